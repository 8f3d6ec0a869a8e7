# The four objects, filled by the preset fast and cut open: above by state, below by set.
# cutaways-panels.png is drawn by Frostfill: panels of 240 x 240 pixels, each above a strip of 26.
name = "cutaways"
height = 540
scale = 1.1
load "style.gp"
unset border
unset tics
unset grid
set lmargin at screen 0.03
set rmargin at screen 0.9997
set tmargin at screen 0.995
set bmargin at screen 0.0994
set xrange [-0.5:3.5]
set yrange [1.5:-0.5]
set label "by state" at screen 0.018,0.79 center rotate font ",15"
set label "by set, first (dark) to last (bright)" at screen 0.018,0.35 center rotate font ",15"
set key at screen 0.5,0.01 center bottom maxrows 1 width 2 samplen 1.5
plot "cutaways-panels.png" binary filetype=png dx=(1.0/240) dy=(1.0/266) \
        origin=(-0.5+0.5/240,-0.5+0.5/266) flipy with rgbimage notitle, \
    for [row=0:1] "cutaways.csv" using "column":(row + 0.44):\
        (sprintf("%d spheres", column("spheres"))) with labels font ",13" textcolor rgb black \
        notitle, \
    NaN with points pointtype 7 pointsize 1.6 linecolor rgb frozen_colour title "frozen", \
    NaN with points pointtype 7 pointsize 1.6 linecolor rgb discarded_colour \
        title "discarded (striped)", \
    NaN with points pointtype 5 pointsize 1.6 linecolor rgb discarded_polygon_colour \
        title "discarded polygons"
