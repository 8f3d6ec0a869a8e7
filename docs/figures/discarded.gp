# What is not tested any more, in per cent of what is present, while 2,000 spheres fill each of the
# four objects: by the paper's rules and by reachability.
name = "discarded"
height = 520
load "style.gp"
objects = "torus sphere cube human"
titles = "Torus Sphere Cube Human"
colours = "#d55e00 #0072b2 #009e73 #cc79a7"
at(object, rule, x) = strcol("object") eq object && strcol("rule") eq rule ? column(x) : NaN
set xrange [0:100]
set yrange [0:100]
set xlabel "spheres present [% of all]"
set multiplot layout 1,2 margins 0.085,0.975,0.27,0.92 spacing 0.115
set key at screen 0.5,0.01 center bottom maxrows 2 width 2
set title "Spheres" font ",16"
set ylabel "discarded [% of those present]" offset 1
plot for [i=1:4] "discarded.csv" using "present_percent":\
        (at(word(objects, i), "exact", "discarded_spheres_percent")) with lines linewidth 2.4 \
        linecolor rgb word(colours, i) title word(titles, i).", exact", \
    for [i=1:4] "discarded.csv" using "present_percent":\
        (at(word(objects, i), "paper", "discarded_spheres_percent")) with lines linewidth 2 \
        dashtype 2 linecolor rgb word(colours, i) title word(titles, i).", paper"
unset key
set title "Polygons"
set ylabel "discarded [% of the mesh]"
plot for [i=1:4] "discarded.csv" using "present_percent":\
        (at(word(objects, i), "exact", "discarded_polygons_percent")) with lines linewidth 2.4 \
        linecolor rgb word(colours, i), \
    for [i=1:4] "discarded.csv" using "present_percent":\
        (at(word(objects, i), "paper", "discarded_polygons_percent")) with lines linewidth 2 \
        dashtype 2 linecolor rgb word(colours, i)
unset multiplot
