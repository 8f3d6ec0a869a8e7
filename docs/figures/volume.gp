# The paper's Figure 1: (A) a volume that fills, (B) what is done with each pair of groups, (C) the
# same moment with discards. Panels A and C are drawn by Frostfill, side by side in
# volume-panels.png; B is volume-pairs.csv.
name = "volume"
width = 1000
height = 430
load "style.gp"
unset grid
set multiplot
set label 1 "(A) running and frozen" at screen 0.165,0.955 center font ",15"
set label 2 "(B) pairs of groups" at screen 0.535,0.955 center font ",15"
set label 3 "(C) with discards" at screen 0.85,0.955 center font ",15"
unset border
unset tics
set size ratio -1
set tmargin at screen 0.92
set bmargin at screen 0.17
set lmargin at screen 0.0
set rmargin at screen 0.33
set xrange [0:419]
set yrange [0:419]
set key at screen 0.5,0.015 center bottom maxrows 1 width 2 samplen 1.5
plot "volume-panels.png" binary filetype=png with rgbimage notitle, \
    NaN with points pointtype 7 pointsize 1.6 linecolor rgb running_colour title "running", \
    NaN with points pointtype 7 pointsize 1.6 linecolor rgb frozen_colour title "frozen", \
    NaN with points pointtype 7 pointsize 1.6 linecolor rgb discarded_colour title "discarded", \
    NaN with points pointtype 5 pointsize 1.6 linecolor rgb "#fbe8bf" title "not tested"
unset key
unset label
set lmargin at screen 0.685
set rmargin at screen 1.0
set xrange [420:839]
plot "volume-panels.png" binary filetype=png with rgbimage notitle
kinds = "running frozen none discarded"
fills = running_colour." ".frozen_colour." #fbe8bf ".discarded_colour
of(kind, x) = strcol("kind") eq kind ? x : NaN
set lmargin at screen 0.41
set rmargin at screen 0.66
set tmargin at screen 0.9
set bmargin at screen 0.25
set border 3
set tics nomirror out
set xrange [0:*]
set yrange [*:0]
set xtics 8
set ytics 8
set xlabel "group" offset 0,0.4
set ylabel "group" offset 1
plot for [k=1:4] "volume-pairs.csv" using (of(word(kinds, k), column("j"))):"i":(0.46):(0.46) \
    with boxxyerror fillstyle solid noborder linecolor rgb word(fills, k) notitle
unset multiplot
