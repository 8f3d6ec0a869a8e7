# The paper's Figure 3 and ours: sphere-polygon work in milliseconds a frame. A mark is the mean, a
# bar goes from the first set after a freezing to the last one before the next.
name = "times"
height = 480
load "style.gp"
series = "'paper loop' 'paper tree' loop list tree grid"
titles = "'paper, loop' 'paper, tree' 'loop' 'linked list' 'tree' 'grid'"
colours = "#202020 #202020 #d55e00 #cc79a7 #e69f00 #0072b2"
marks = "7 6 5 9 13 11"
at(name, x) = strcol("series") eq name ? column(x) : NaN
set logscale y
set format y "10^{%T}"
set ylabel "sphere–polygon work [ms a frame]"
set xrange [-0.5:3.5]
set xtics ("Torus" 0, "Sphere" 1, "Cube" 2, "Human" 3) scale 0 font ",16"
set key outside right top Left
plot for [i=1:6] "times.csv" using (at(word(series, i), "number") + 0.12 * (i - 3.5)):"ms":"low":"high" \
    with yerrorbars pointtype int(word(marks, i)) pointsize 1.2 linewidth 1.6 \
    linecolor rgb word(colours, i) title word(titles, i)
