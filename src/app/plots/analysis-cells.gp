# Local packing fractions of whole Voronoi cells.
name = "cells"
height = 420
load "style.gp"
set xlabel "sphere's share of its Voronoi cell"
set ylabel "cells"
set yrange [0:*]
unset key
plot "cells.csv" using ((column("from") + column("to")) / 2):"cells":\
        (column("to") - column("from")) with boxes fillstyle solid 0.6 noborder \
        linecolor rgb blue
