# The four objects while they fill, with the paper's method. filling-panels.png is drawn by
# Frostfill, filling.csv tells what is in each of its panels.
name = "filling"
height = 830
load "style.gp"
unset border
unset tics
unset grid
set margins 0, 0, 0, 0
set multiplot
set lmargin at screen 0.02
set rmargin at screen 0.98
set tmargin at screen 0.99
set bmargin at screen 0.06
set xrange [-0.5:4.5]
set yrange [3.62:-0.5]
plot "filling-panels.png" binary filetype=png dx=(1.0/270) dy=(1.0/270) \
        origin=(-0.498,-0.498) flipy with rgbimage notitle, \
    "filling.csv" using "column":(column("row") + 0.52):(sprintf("%d spheres", column("spheres"))) \
        with labels font ",13" textcolor rgb black notitle
unset multiplot
