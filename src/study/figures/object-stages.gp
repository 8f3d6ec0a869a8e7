# One object while it fills, in four stages. stages-panels.png is drawn by Frostfill: panels of
# 300 x 300 pixels, each above a strip of 30; stages.csv tells what is in them.
name = "stages"
width = 1240
height = 390
scale = 1.2
load "style.gp"
unset border
unset tics
unset grid
set lmargin at screen 0.01
set rmargin at screen 0.99
set tmargin at screen 0.995
set bmargin at screen 0.12
set xrange [-0.5:3.5]
set yrange [0.5:-0.5]
set key at screen 0.5,0.01 center bottom maxrows 1 width 2 samplen 1.5
plot "stages-panels.png" binary filetype=png dx=(1.0/300) dy=(1.0/330) \
        origin=(-0.5+0.5/300,-0.5+0.5/330) flipy with rgbimage notitle, \
    "stages.csv" using "column":(0.46):(sprintf("%d spheres", column("spheres"))) \
        with labels font ",14" textcolor rgb black notitle, \
    NaN with points pointtype 7 pointsize 1.6 linecolor rgb running_colour title "running", \
    NaN with points pointtype 7 pointsize 1.6 linecolor rgb frozen_colour title "frozen", \
    NaN with points pointtype 7 pointsize 1.6 linecolor rgb discarded_colour title "discarded"
