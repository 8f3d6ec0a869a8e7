# Q6 of the spheres.
name = "order"
height = 420
load "style.gp"
set xlabel "Q6"
set ylabel "spheres"
set yrange [0:*]
unset key
plot "order.csv" using ((column("from") + column("to")) / 2):"spheres":\
        (column("to") - column("from")) with boxes fillstyle solid 0.6 noborder \
        linecolor rgb blue
