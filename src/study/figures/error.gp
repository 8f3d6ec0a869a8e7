# Run time against error, a point a run. Rings: no other run is both faster and better. Squares: the
# defaults.
name = "error"
width = 1300
height = 1000
load "style.gp"
floor = 1e-16
clip(x) = x > floor ? x : floor
on(curve, x) = strcol("curve") eq curve ? column(x) : NaN
front(x) = column("front") == 1 ? column(x) : NaN
ours(x) = column("default") == 1 ? column(x) : NaN
colours = "#0072b2 #56b4e9 #d55e00 #e69f00 #009e73"
marks = "5 9 7 11 13"
set datafile missing NaN
set logscale xy
set format x "%g"
set format y "10^{%T}"
set xlabel "processor time [s]"
set multiplot layout 2,2 margins 0.075,0.985,0.075,0.95 spacing 0.085,0.125
set title "Steps: overlap + unsupported share" font ",16"
set ylabel "largest overlap [r] + unsupported share"
curves = "'fast' 'fast skip' 'paper' 'paper semi-implicit'"
set key inside center right
data = "error-steps.csv"
plot for [i=1:4] data using (on(word(curves,i),"seconds")):(clip(on(word(curves,i),"error"))) \
        with points pointtype int(word(marks,i)) pointsize 1.2 linecolor rgb word(colours,i) \
        title word(curves,i), \
    data using (front("seconds")):(clip(front("error"))) with points pointtype 6 pointsize 2.6 \
        linewidth 2 linecolor rgb black title "Pareto front", \
    data using (ours("seconds")):(clip(ours("error"))) with points pointtype 4 pointsize 3.4 \
        linewidth 2 linecolor rgb purple title "our default"
set title "Discards: deviation from the run without"
set ylabel "farthest deviation [r]"
set xlabel "share of spheres dropped [%]"
unset logscale x
set key inside center right
data = "error-discards.csv"
plot data using (100*on("paper","spheres_dropped")):(clip(on("paper","error"))) with points \
        pointtype 7 pointsize 1.3 linecolor rgb vermillion title "paper's rules", \
    data using (100*on("exact","spheres_dropped")):(clip(on("exact","error"))) with points \
        pointtype 5 pointsize 1.5 linecolor rgb blue title "exact rule: the same bits"
set title "Volume: radius against error"
set ylabel "error of the volume [%]"
set xlabel "r S / V"
set logscale x
unset logscale y
set format y "%g"
set key inside top left
objects = "torus sphere cube human"
data = "error-volume.csv"
plot for [i=1:4] data using (on(word(objects,i),"rS_over_V")):(100*on(word(objects,i), \
        "corrected_error")) with linespoints pointtype int(word(marks,i)) linewidth 1.8 \
        linecolor rgb word(colours,i) title word(objects,i), \
    1 with lines dashtype 2 linecolor rgb black title "±1 %", \
    -1 with lines dashtype 2 linecolor rgb black notitle
set title "Layers in a set: packing fraction far from walls"
set ylabel "packing fraction"
set xlabel "layers in a set"
set yrange [0.56:0.69]
set key inside top right
data = "error-layers.csv"
plot for [i=1:1] data using (on("fast","layers")):(on("fast","fraction")) with linespoints \
        pointtype 5 linewidth 2 linecolor rgb blue title "fast", \
    0.639 with lines dashtype 2 linecolor rgb black title "random close packing, 0.639", \
    0.60 with lines dashtype 3 linecolor rgb black title "0.60", \
    0.582 with lines dashtype 4 linecolor rgb black title "drop and roll, 0.582"
unset multiplot
