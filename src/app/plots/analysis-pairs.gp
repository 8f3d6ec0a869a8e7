# The pair correlation, and how many neighbours a sphere has up to a distance.
name = "pairs"
load "style.gp"
set xlabel "distance [mesh unit]"
set ylabel "g(r)"
set y2label "neighbours"
set y2tics textcolor rgb black
set border 11
set key top left
plot "pairs.csv" using ((column("from") + column("to")) / 2):"g" with lines linewidth 1.8 \
        linecolor rgb blue title "g(r)", \
    "" using "to":"neighbours" axes x1y2 with lines linewidth 1.8 dashtype 2 \
        linecolor rgb vermillion title "neighbours up to the distance"
