# The four objects, filled by the preset fast and cut open: above by state, below by set, from the
# first (dark) to the last. cutaways-panels.png is drawn by Frostfill.
name = "cutaways"
height = 500
load "style.gp"
unset border
unset tics
unset grid
set lmargin at screen 0.03
set rmargin at screen 0.99
set tmargin at screen 0.99
set bmargin at screen 0.01
set xrange [-0.5:3.5]
set yrange [1.62:-0.5]
plot "cutaways-panels.png" binary filetype=png dx=(1.0/330) dy=(1.0/330) \
        origin=(-0.498,-0.498) flipy with rgbimage notitle, \
    "cutaways.csv" using "column":(0.52):(sprintf("%d spheres", column("spheres"))) with labels \
        font ",13" textcolor rgb black notitle
