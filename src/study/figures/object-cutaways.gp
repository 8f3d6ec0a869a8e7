# One object, filled and cut open: by state, by set and by height. cutaways-panels.png is drawn by
# Frostfill: panels of 380 x 380 pixels, each above a strip of 30.
name = "cutaways"
width = 1180
height = 470
scale = 1.2
load "style.gp"
unset border
unset tics
unset grid
unset key
set lmargin at screen 0.01
set rmargin at screen 0.99
set tmargin at screen 0.995
set bmargin at screen 0.01
set xrange [-0.5:2.5]
set yrange [0.5:-0.5]
plot "cutaways-panels.png" binary filetype=png dx=(1.0/380) dy=(1.0/410) \
        origin=(-0.5+0.5/380,-0.5+0.5/410) flipy with rgbimage notitle, \
    "cutaways.csv" using "column":(0.465):"label" with labels font ",15" textcolor rgb black \
        notitle
