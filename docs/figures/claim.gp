# The paper's claim: the number of spheres grows, the number of operations holds. A fill of the
# torus in sets of two groups of fifty. claim.csv has the points, claim-growth.csv by how much more
# a frame, and a sphere, costs in the last tenth of the sets than in the first.
name = "claim"
height = 980
load "style.gp"
methods = "'all running' freezing discards grid fast"
titles = "'nothing frozen' 'freezing each set' '+ both discards' 'our grids' 'our engine (fast)'"
colours = "#202020 #d55e00 #e69f00 #56b4e9 #0072b2"
marks = "1 7 5 9 13"
at(method, x) = strcol("method") eq method ? column(x) : NaN
set logscale y
set xtics 0,2500,10000 format "%.0f"
set xrange [0:13000]
set multiplot layout 2,2 margins 0.1,0.985,0.155,0.955 spacing 0.125,0.115
set format y "10^{%T}"
set key at screen 0.5,0.008 center bottom maxrows 2 width 1
quantities = "ms tests sphere_ms sphere_tests"
headings = "'Time of a frame' 'Tests of a frame' 'Time of a sphere, until it rests' 'Tests of a sphere, until it rests'"
labels = "milliseconds 'pairs tested' milliseconds 'pairs tested'"
do for [panel=1:4] {
    what = word(quantities, panel)
    # What a sphere costs when nothing is frozen is not known: only single steps are timed.
    from = panel < 3 ? 1 : 2
    # Two curves end so close together that their labels would lie on each other.
    above = panel == 1 ? "0 0 0 -0.5 0.5" : "0 0 0 0 0"
    set title word(headings, panel) font ",16"
    set ylabel word(labels, panel)
    set xlabel panel < 3 ? "" : "spheres present"
    plot for [i=from:5] "claim.csv" using "spheres":(at(word(methods, i), what)) with points \
            pointtype int(word(marks, i)) pointsize 0.7 linecolor rgb word(colours, i) \
            title word(titles, i), \
        for [i=from:5] "claim-growth.csv" using "spheres":(at(word(methods, i), what)): \
            (sprintf("%+.0f %%", column(what."_growth_percent"))) with labels left \
            offset 0.6,real(word(above, i)) font ",13" textcolor rgb word(colours, i) notitle
    unset key
}
unset multiplot
