# What is not tested any more, in per cent of what is present, while 2,000 spheres fill each of the
# four objects: by reachability, which changes no result, and by the paper's rules.
name = "discarded"
height = 760
load "style.gp"
objects = "torus sphere cube human"
titles = "Torus Sphere Cube Human"
colours = "#d55e00 #0072b2 #009e73 #cc79a7"
marks = "7 5 9 13"
at(object, rule, x) = strcol("object") eq object && strcol("rule") eq rule ? column(x) : NaN
rules = "exact paper"
names = "'exact: by reachability' 'paper: by height and covered vertices'"
columns = "discarded_spheres_percent discarded_polygons_percent"
labels = "'spheres discarded [% of those present]' 'polygons discarded [% of the mesh]'"
set xrange [0:100]
set yrange [0:100]
set multiplot layout 2,2 margins 0.095,0.975,0.135,0.95 spacing 0.07,0.075
set key at screen 0.52,0.01 center bottom maxrows 1 width 3 samplen 3
do for [row=1:2] {
    do for [rule=1:2] {
        set title row == 1 ? word(names, rule) : "" font ",16"
        set ylabel rule == 1 ? word(labels, row) : "" offset 0
        set xlabel row == 2 ? "spheres present [% of all]" : ""
        plot for [i=1:4] "discarded.csv" using "present_percent":\
            (at(word(objects, i), word(rules, rule), word(columns, row))) with linespoints \
            pointtype int(word(marks, i)) pointinterval -14 pointsize 0.9 linewidth 2 \
            linecolor rgb word(colours, i) title row == 1 && rule == 1 ? word(titles, i) : ""
    }
}
unset multiplot
