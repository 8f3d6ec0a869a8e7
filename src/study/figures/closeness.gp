# How close a sphere has to be to cover a polygon, against the polygons that the preset paper
# discards, the centres that end outside, and the largest overlap. Dashes: what the paper reports.
name = "closeness"
width = 1300
height = 480
load "style.gp"
objects = "torus sphere cube human"
titles = "Torus Sphere Cube Human"
colours = "#d55e00 #0072b2 #009e73 #cc79a7"
marks = "7 5 9 13"
on(object, x) = strcol("object") eq object ? column(x) : NaN
columns = "polygons_percent outside max_overlap"
heads = "'polygons discarded [%]' 'centres outside' 'largest overlap of two spheres [r]'"
set datafile missing NaN
set xlabel "largest distance of a covering sphere [r]"
set xrange [0:3.1]
set yrange [0:*]
set multiplot layout 1,3 margins 0.04,0.985,0.24,0.91 spacing 0.05,0.1
set key at screen 0.51,0.01 center bottom maxrows 1 width 3 samplen 3
do for [c=1:3] {
    set title word(heads, c) font ",16"
    set label 1 "dashed: the paper's, 51 % and three below 1 %" at graph 0.04,0.93 textcolor rgb black
    if (c > 1) { unset label 1 }
    plot for [i=1:4] "closeness.csv" using "closeness":\
        (on(word(objects, i), word(columns, c))) with linespoints \
        pointtype int(word(marks, i)) pointsize 1.1 linewidth 2 \
        linecolor rgb word(colours, i) title c == 2 ? word(titles, i) : "", \
        for [i=1:(c == 1 ? 4 : 0)] "closeness.csv" using "closeness":\
        (on(word(objects, i), "paper_percent")) with lines dashtype 2 \
        linewidth 1.5 linecolor rgb word(colours, i) notitle
}
unset multiplot
