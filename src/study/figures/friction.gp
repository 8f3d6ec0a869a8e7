# How loosely and how densely grains rest together, and on how many contacts, by friction; about
# 2,200 spheres in the cube, one pile each. Published values: without friction, and compressed with
# 0.3, by Agnolin and Roux (2007); the loosest packing of rough spheres by Onoda and Liniger (1990).
name = "friction"
width = 900
height = 460
load "style.gp"
set multiplot layout 1,2
set xrange [-0.05:1.1]
set xlabel "friction"
at(what, y) = strcol("preparation") eq what ? column(y) : NaN

set key bottom right
set yrange [0.5:0.65]
set ylabel "packing fraction of the bulk"
$published << END
friction,fraction,contacts
0,0.639,6
0.3,0.593,4.5
END
plot "friction.csv" using "friction":(at("densest", "fraction")) with linespoints pointtype 5 \
        linewidth 1.8 linecolor rgb blue title "densest", \
    "friction.csv" using "friction":(at("loosest", "fraction")) with linespoints pointtype 7 \
        linewidth 1.8 dashtype 2 linecolor rgb vermillion title "loosest", \
    $published using "friction":"fraction" with points pointtype 8 pointsize 1.4 \
        linecolor rgb black title "published, compressed", \
    0.555 with lines dashtype 3 linewidth 1.6 linecolor rgb black title "published, loosest"

set key top right
set yrange [3.5:6.5]
set ylabel "contacts of a sphere in the bulk"
plot "friction.csv" using "friction":(at("densest", "contacts")) with linespoints pointtype 5 \
        linewidth 1.8 linecolor rgb blue title "densest", \
    "friction.csv" using "friction":(at("loosest", "contacts")) with linespoints pointtype 7 \
        linewidth 1.8 dashtype 2 linecolor rgb vermillion title "loosest", \
    $published using "friction":"contacts" with points pointtype 8 pointsize 1.4 \
        linecolor rgb black title "published, compressed"
unset multiplot
