# Size curves by mass of the cube, 1:10, as asked and as achieved, and how far they are apart.
name = "sizes"
height = 640
load "style.gp"
runs = "count full_within full"
titles = "'a count' 'until full, within 0.5 %' 'until no sphere fits'"
colours = "#0072b2 #009e73 #d55e00"
marks = "5 7 9"
at(run, x) = strcol("run") eq run ? column(x) : NaN
set multiplot layout 2,1
set key top left
set ylabel "passing [% of the mass]"
plot "sizes.csv" using "radius":(at("count", "asked_percent")) with lines linewidth 1.8 \
        linecolor rgb black title "asked", \
    for [i=1:3] "sizes.csv" using "radius":(at(word(runs, i), "achieved_percent")) with points \
        pointtype int(word(marks, i)) pointsize 1 linecolor rgb word(colours, i) \
        title word(titles, i)
set xlabel "radius [mesh unit]"
set ylabel "achieved less asked [%]"
unset key
plot for [i=1:3] "sizes.csv" using "radius":(at(word(runs, i), "achieved_percent") - \
        column("asked_percent")) with linespoints pointtype int(word(marks, i)) pointsize 1 \
        linewidth 1.8 dashtype i linecolor rgb word(colours, i) notitle
unset multiplot
