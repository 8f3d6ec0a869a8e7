# How many spheres touch how many others; rattlers among them.
name = "contacts"
height = 420
load "style.gp"
set xlabel "contacts with spheres"
set ylabel "spheres"
set xtics 1
set yrange [0:*]
set boxwidth 0.8
set key top right
plot "contacts.csv" using "contacts":"spheres" with boxes fillstyle solid 0.6 noborder \
        linecolor rgb blue title "all", \
    "" using "contacts":"rattlers" with boxes fillstyle solid 0.8 noborder \
        linecolor rgb orange title "rattlers"
