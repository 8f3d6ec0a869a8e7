# Processor time against the number of triangles of one object: what a run starts with, and what
# each sphere and each picture costs then.
name = "triangles"
height = 480
load "style.gp"
data = "triangles.csv"
set logscale xy
set xlabel "triangles"
set format x "10^{%T}"
set key inside top left
set multiplot layout 1,2 margins 0.095,0.98,0.15,0.9 spacing 0.125
set title "Before the first step" font ",16"
set ylabel "processor time [s]"
set format y "10^{%T}"
proportional(x) = 2e-6 * x
plot data using "triangles":"load" with linespoints linewidth 2 pointtype 7 pointsize 0.9 \
        linecolor rgb blue title "load and repair", \
    data using "triangles":"prepare" with linespoints linewidth 2 pointtype 5 pointsize 0.9 \
        linecolor rgb vermillion title "prepare the simulation", \
    proportional(x) with lines dashtype 3 linewidth 2 linecolor rgb black title "proportional"
set title "For each one then" font ",16"
set ylabel "processor time [ms]"
plot data using "triangles":(1000*column("sphere")) with linespoints linewidth 2 pointtype 9 \
        pointsize 1 linecolor rgb green title "a sphere", \
    data using "triangles":(1000*column("picture")) with linespoints linewidth 2 pointtype 11 \
        pointsize 1 linecolor rgb purple title "a picture"
unset multiplot
