# Errors against closed forms over the time step; lines are slopes. What is exact lies on the floor.
name = "closed-forms"
width = 1100
height = 520
load "style.gp"
data = "closed-forms.csv"
floor = 1e-16
is(p, m) = strcol("problem") eq p && strcol("method") eq m
at(p, m) = is(p, m) ? (column("magnitude") > floor ? column("magnitude") : floor) : NaN
set datafile missing NaN
set logscale xy
set format y "10^{%T}"
set xlabel "step [sqrt(r/g)]"
set yrange [3e-17:3]
set xrange [7e-4:0.14]
set multiplot layout 1,2 margins 0.09,0.985,0.3,0.92 spacing 0.1
set title "Free fall and throw" font ",16"
set ylabel "error [r]"
set key at screen 0.06,0.015 left bottom maxcols 1
plot data using "value":(at("free fall", "explicit Euler")) with linespoints pointtype 7 \
        linewidth 2 linecolor rgb vermillion title "free fall, explicit Euler: +gT dt/2", \
    data using "value":(at("free fall", "semi-implicit Euler")) with linespoints pointtype 4 \
        pointsize 1.6 dashtype 2 linewidth 2 linecolor rgb orange \
        title "free fall, semi-implicit Euler: -gT dt/2", \
    data using "value":(at("free fall", "exact step")) with linespoints pointtype 5 linewidth 2 \
        linecolor rgb blue title "free fall, our step", \
    data using "value":(at("throw", "exact step")) with linespoints pointtype 9 dashtype 3 \
        linewidth 2 linecolor rgb green title "throw, our step"
set title "Bounce (apex e^2h) and head-on pair"
set ylabel "relative error"
set key at screen 0.58,0.015 left bottom
plot data using "value":(at("bounce", "explicit Euler")) with linespoints pointtype 7 \
        linewidth 2 linecolor rgb vermillion title "bounce, explicit Euler", \
    data using "value":(at("bounce", "semi-implicit Euler")) with linespoints pointtype 4 \
        pointsize 1.6 dashtype 2 linewidth 2 linecolor rgb orange title "bounce, semi-implicit", \
    data using "value":(at("bounce", "exact step")) with linespoints pointtype 5 linewidth 2 \
        linecolor rgb blue title "bounce, our step", \
    data using "value":(at("head-on pair", "exact step")) with linespoints pointtype 11 \
        dashtype 3 linewidth 2 linecolor rgb purple title "head-on pair, our step"
unset multiplot
