# What is not tested any more while one object fills, in per cent of the spheres that are present
# and of the mesh.
name = "discards"
load "style.gp"
set xlabel "spheres present"
set ylabel "discarded [%]"
set xrange [0:*]
set yrange [0:100]
set key inside bottom right
plot "discards.csv" using "spheres":"discarded_spheres_percent" with linespoints pointtype 7 \
        pointinterval -14 linewidth 2 linecolor rgb vermillion title "spheres", \
    "discards.csv" using "spheres":"discarded_polygons_percent" with linespoints pointtype 5 \
        pointinterval -14 linewidth 2 linecolor rgb blue title "polygons"
