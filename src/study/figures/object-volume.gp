# How much of one object's volume the spheres fill.
name = "volume"
load "style.gp"
set xlabel "spheres present"
set ylabel "volume of the spheres [% of the object's]"
set xrange [0:*]
set yrange [0:70]
set key inside bottom right
plot "volume.csv" using "spheres":"filled_percent" with linespoints pointtype 7 \
        pointinterval -14 linewidth 2 linecolor rgb blue title "filled", \
    64 with lines dashtype 2 linecolor rgb black title "random close packing without walls, 64 %"
