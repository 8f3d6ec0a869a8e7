# How densely the cube fills when it is filled until no sphere fits, by how many spheres appear
# together; about 1,000 spheres, five seeds, bars are 95 % confidence intervals of the mean.
name = "density"
height = 480
load "style.gp"
methods = "paper fast skip"
titles = "'paper' 'fast, every moment of the fall' 'fast, from the first contact on'"
colours = "#d55e00 #0072b2 #009e73"
marks = "7 5 9"
at(method, x) = strcol("method") eq method ? column(x) : NaN
set logscale x
set xrange [0.8:125]
set xtics (1, 2, 5, 10, 20, 50, 100)
set xlabel "spheres in a set"
set ylabel "volume filled [%]"
set key top left
plot for [i=1:3] "density.csv" using "set_size":(at(word(methods, i), "packing_percent")):\
        "half_width_95" with yerrorlines pointtype int(word(marks, i)) pointsize 1.2 linewidth 1.8 \
        dashtype i linecolor rgb word(colours, i) title word(titles, i)
