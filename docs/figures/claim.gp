# The paper's claim: the number of spheres grows, the number of operations holds. A fill of the cube
# in sets of two groups. claim.csv has the points, claim-growth.csv by how much a frame costs more
# in the last tenth of the sets than in the first.
name = "claim"
height = 560
load "style.gp"
methods = "'all running' freezing discards grid fast"
titles = "'nothing frozen' 'freezing each set' '+ both discards' 'our grids' 'our engine (fast)'"
colours = "#202020 #d55e00 #e69f00 #56b4e9 #0072b2"
marks = "1 7 5 9 13"
at(method, x) = strcol("method") eq method ? column(x) : NaN
set logscale y
set format x "%.0f"
set xlabel "spheres present"
set multiplot layout 1,2 margins 0.085,0.93,0.27,0.92 spacing 0.13
set key at screen 0.5,0.015 center bottom maxrows 2 width 1
set title "Time" font ",16"
set ylabel "milliseconds a frame" offset 1
set format y "10^{%T}"
plot for [i=1:5] "claim.csv" using "spheres":(at(word(methods, i), "ms")) with points \
        pointtype int(word(marks, i)) pointsize 0.7 linecolor rgb word(colours, i) \
        title word(titles, i), \
    for [i=1:5] "claim-growth.csv" using "spheres":(at(word(methods, i), "ms")): \
        (sprintf("%+.0f %%", column("ms_growth_percent"))) with labels left offset 0.6,0 \
        font ",13" textcolor rgb word(colours, i) notitle
unset key
set title "Tests"
set ylabel "pairs tested a frame"
plot for [i=1:5] "claim.csv" using "spheres":(at(word(methods, i), "tests")) with points \
        pointtype int(word(marks, i)) pointsize 0.7 linecolor rgb word(colours, i) notitle, \
    for [i=1:5] "claim-growth.csv" using "spheres":(at(word(methods, i), "tests")): \
        (sprintf("%+.0f %%", column("tests_growth_percent"))) with labels left offset 0.6,0 \
        font ",13" textcolor rgb word(colours, i) notitle
unset multiplot
