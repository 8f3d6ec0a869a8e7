# The paper's Figure 2, from a run of the torus: (A) a section through its middle, (B) a section
# through an edge of a polygon that is covered, with the rays from its vertices, (C) which pairs of
# groups are tested while the third set of three groups runs. Lengths are in radii.
name = "interaction"
width = 1000
height = 440
load "style.gp"
unset grid
states = "discarded frozen running"
fills = discarded_colour." ".frozen_colour." ".running_colour
of(state, x) = strcol("state") eq state ? x : NaN
set multiplot
set label 1 "(A) spheres and polygons" at screen 0.18,0.955 center font ",15"
set label 2 "(B) a covered polygon" at screen 0.53,0.955 center font ",15"
set label 3 "(C) three sets of three groups" at screen 0.84,0.955 center font ",15"
unset border
unset tics
set size ratio -1
set style fill solid 1 border rgb "#404040"
set tmargin at screen 0.92
set bmargin at screen 0.19
set lmargin at screen 0.01
set rmargin at screen 0.35
set key at screen 0.5,0.01 center bottom maxrows 2 width 2 samplen 1.6
plot for [k=1:3] "interaction-spheres.csv" using (of(word(states, k), column("x"))):"y":"radius" \
        with circles linecolor rgb word(fills, k) notitle, \
    "interaction-polygons.csv" using (of("active", column("x"))):"y":"dx":"dy" with vectors nohead \
        linewidth 2.2 linecolor rgb black title "polygon", \
    "" using (of("discarded", column("x"))):"y":"dx":"dy" with vectors nohead linewidth 5 \
        linecolor rgb discarded_polygon_colour title "discarded polygon", \
    NaN with points pointtype 7 pointsize 1.5 linecolor rgb running_colour title "running", \
    NaN with points pointtype 7 pointsize 1.5 linecolor rgb frozen_colour title "frozen", \
    NaN with points pointtype 7 pointsize 1.5 linecolor rgb discarded_colour title "discarded", \
    NaN with points pointtype 5 pointsize 1.5 linecolor rgb "#fbe8bf" title "not tested"
unset key
unset label
set lmargin at screen 0.385
set rmargin at screen 0.675
set xrange [-3:3]
set yrange [-1:4.6]
plot for [k=1:3] "interaction-covering.csv" using (of(word(states, k), column("x"))):"y":"radius" \
        with circles linecolor rgb word(fills, k), \
    "interaction-rays.csv" using "x":"y":"dx":"dy" with vectors head size 0.2,20 filled linewidth 2 \
        linecolor rgb vermillion, \
    "" using (strcol("where") eq "edge" ? column("x") : NaN):"y" with lines linewidth 5 \
        linecolor rgb discarded_polygon_colour, \
    "" using "x":"y" with points pointtype 7 pointsize 1.1 linecolor rgb black
kinds = "running frozen none discarded"
colours = running_colour." ".frozen_colour." #fbe8bf ".discarded_colour
kind(name, x) = strcol("kind") eq name ? x : NaN
set lmargin at screen 0.73
set rmargin at screen 0.97
set tmargin at screen 0.9
set bmargin at screen 0.27
set border 3
set tics nomirror out 1
set xrange [0.4:9.6]
set yrange [9.6:0.4]
set xlabel "group" offset 0,0.4
set ylabel "group" offset 1
plot for [k=1:4] "interaction-pairs.csv" using (kind(word(kinds, k), column("j"))):"i":(0.46):(0.46) \
    with boxxyerror fillstyle solid noborder linecolor rgb word(colours, k)
unset multiplot
