# The four objects while they fill, with the paper's method. filling-panels.png is drawn by
# Frostfill: panels of 190 x 190 pixels, each above a strip of 26; filling.csv tells what is in them.
name = "filling"
height = 840
scale = 1.1
load "style.gp"
unset border
unset tics
unset grid
set lmargin at screen 0.0202
set rmargin at screen 0.9798
set tmargin at screen 0.995
set bmargin at screen 0.06
set xrange [-0.5:4.5]
set yrange [3.5:-0.5]
set key at screen 0.5,0.005 center bottom maxrows 1 width 2 samplen 1.5
plot "filling-panels.png" binary filetype=png dx=(1.0/190) dy=(1.0/216) \
        origin=(-0.5+0.5/190,-0.5+0.5/216) flipy with rgbimage notitle, \
    "filling.csv" using "column":(column("row") + 0.44):(sprintf("%d spheres", column("spheres"))) \
        with labels font ",13" textcolor rgb black notitle, \
    NaN with points pointtype 7 pointsize 1.6 linecolor rgb running_colour title "running", \
    NaN with points pointtype 7 pointsize 1.6 linecolor rgb frozen_colour title "frozen", \
    NaN with points pointtype 7 pointsize 1.6 linecolor rgb discarded_colour \
        title "discarded (striped)"
