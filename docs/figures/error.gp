# Run time against error, a point a run. Rings: no rival is both faster and better. Squares: the
# defaults.
name = "error"
width = 1300
height = 1920
load "style.gp"
floor = 1e-9
clip(x) = x > floor ? x : floor
on(curve, x) = strcol("curve") eq curve ? column(x) : NaN
object(curve, name, x) = strcol("curve") eq curve && strcol("rivals") eq name ? column(x) : NaN
front(x) = column("front") == 1 ? column(x) : NaN
ours(x) = column("default") == 1 ? column(x) : NaN
colours = "#0072b2 #56b4e9 #d55e00 #e69f00 #009e73"
marks = "5 9 7 11 13"
set datafile missing NaN
set logscale xy
set format x "%g"
set format y "10^{%T}"
set xlabel "processor time [s]"
set multiplot layout 4,2 margins 0.075,0.985,0.038,0.974 spacing 0.095,0.064
set title "Steps and sweeps: overlap in motion + unsupported" font ",16"
set ylabel "mean largest overlap [r] + unsupported share"
curves = "'fast' 'fast skip' 'paper' 'paper semi-implicit'"
set key inside top right
set yrange [1e-4:100]
data = "error-steps.csv"
plot for [i=1:4] data using (on(word(curves,i),"seconds")):(clip(on(word(curves,i),"error"))) \
        with points pointtype int(word(marks,i)) pointsize 1.1 linecolor rgb word(colours,i) \
        title word(curves,i), \
    data using (front("seconds")):(clip(front("error"))) with points pointtype 6 pointsize 2.2 \
        linewidth 2 linecolor rgb black title "front, fall or skip", \
    data using (ours("seconds")):(clip(ours("error"))) with points pointtype 4 pointsize 2.8 \
        linewidth 2 linecolor rgb purple title "our defaults"
set yrange [*:*]
set title "Discards: deviation from the run without"
set ylabel "farthest deviation [r]"
set xlabel "share of spheres dropped [%]"
unset logscale x
set key inside center right
data = "error-discards.csv"
plot data using (100*on("paper","spheres_dropped")):(clip(on("paper","error"))) with points \
        pointtype 7 pointsize 1.3 linecolor rgb vermillion title "paper's rules", \
    data using (100*on("exact","spheres_dropped")):(clip(on("exact","error"))) with points \
        pointtype 5 pointsize 1.5 linecolor rgb blue title "exact rule: no deviation"
set title "Volume: radius against error"
set ylabel "error of the volume [%]"
set xlabel "r S / V"
set logscale x
unset logscale y
set format y "%g"
set key inside top left
set yrange [-6:8]
objects = "torus sphere cube human"
data = "error-volume.csv"
plot for [i=1:4] data using (object("wall-corrected",word(objects,i),"rS_over_V")): \
        (100*object("wall-corrected",word(objects,i),"signed_error")) with linespoints \
        pointtype int(word(marks,i)) linewidth 1.8 linecolor rgb word(colours,i) \
        title word(objects,i).", wall-corrected", \
    for [i=1:4] data using (object("two radii",word(objects,i),"rS_over_V")): \
        (100*object("two radii",word(objects,i),"signed_error")) with points \
        pointtype int(word(marks,i))-1 pointsize 1.3 linewidth 1.8 linecolor rgb word(colours,i) \
        title word(objects,i).", two radii", \
    1 with lines dashtype 2 linecolor rgb black title "±1 %", \
    -1 with lines dashtype 2 linecolor rgb black notitle
set yrange [*:*]
set title "Volume: time against error"
set ylabel "error of the volume [%]"
set xlabel "processor time [s]"
set logscale xy
set xrange [0.0005:100]
set key inside bottom left
ways = "'raw' 'wall-corrected' 'two radii'"
plot for [i=1:3] data using (on(word(ways,i),"seconds")):(100*on(word(ways,i),"error")) \
        with points pointtype int(word(marks,i)) pointsize 1.1 linecolor rgb word(colours,i) \
        title word(ways,i), \
    data using (front("seconds")):(100*front("error")) with points pointtype 6 pointsize 2.2 \
        linewidth 2 linecolor rgb black title "front, of one object", \
    data using (ours("seconds")):(100*ours("error")) with points pointtype 4 pointsize 2.8 \
        linewidth 2 linecolor rgb purple title "--estimate-volume"
set xrange [*:*]
unset logscale y
set title "Layers in a set: packing far from walls"
set ylabel "packing fraction"
set xlabel "layers in a set"
set yrange [0.56:0.72]
set y2range [5:8.2]
set y2tics
set key inside top left
data = "error-layers.csv"
plot data using (on("by set","layers")):(on("by set","fraction")) with linespoints \
        pointtype 5 linewidth 2 linecolor rgb blue title "fraction, sets freeze whole", \
    data using (on("one by one","layers")):(on("one by one","fraction")) with linespoints \
        pointtype 4 linewidth 2 linecolor rgb sky title "fraction, each sphere by itself", \
    data using (on("by set","layers")):(on("by set","contacts")) axes x1y2 with linespoints \
        pointtype 7 linewidth 2 linecolor rgb vermillion title "contacts (right), sets freeze whole", \
    0.64 with lines dashtype 2 linecolor rgb black title "random close packing, 0.64", \
    0.60 with lines dashtype 3 linecolor rgb black title "0.60", \
    0.58 with lines dashtype 4 linecolor rgb black title "drop and roll, 0.58", \
    6 axes x1y2 with lines dashtype 5 linecolor rgb vermillion title "isostatic, z = 6 (right)"
unset y2tics
set yrange [*:*]
set logscale xy
set title "Rendering: frame time against pixel error"
set ylabel "difference from the reference [of 255]"
set xlabel "processor time of a picture [s]"
set yrange [0.1:100]
set key inside bottom left
data = "error-rendering.csv"
plot data using (on("exact spheres","seconds")):(on("exact spheres","error")) with points \
        pointtype 5 pointsize 1.5 linecolor rgb blue title "exact spheres, samples 1, 2, 4; 2x2, 3x3, 4x4", \
    data using (on("tessellated spheres","seconds")):(on("tessellated spheres","error")) \
        with points pointtype 7 pointsize 1.3 linecolor rgb vermillion \
        title "tessellated, 80 to 5120 triangles", \
    data using (on("shell","seconds")):(on("shell","error")) with points pointtype 9 \
        pointsize 1.3 linecolor rgb sky title "shell of 1,152 to 294,912 triangles, samples 1, 4", \
    data using (front("seconds")):(front("error")) with points pointtype 6 pointsize 2.4 \
        linewidth 2 linecolor rgb black title "Pareto front", \
    data using (ours("seconds")):(ours("error")) with points pointtype 4 pointsize 3 \
        linewidth 2 linecolor rgb purple title "our default"

held(curve, friction, x) = column("friction") == friction ? on(curve, x) : NaN
ways = "each joint LIGGGHTS"
names = "'each by itself' 'joint' 'LIGGGHTS'"
tints = "#0072b2 #009e73 #d55e00"
marks = "5 9 7"
data = "error-rest.csv"
set title "Rest of all together: what nothing holds when all are let go"
set xlabel "processor time [s]"
set ylabel "share of spheres [%]; none is 0.01"
set yrange [0.007:200]
set format y "%g"
set key inside top right
share(x) = 100 * (x > 1e-4 ? x : 1e-4)
plot for [i=1:3] data using (held(word(ways,i),0,"seconds")):(share(column("error"))) with points \
        pointtype int(word(marks,i)) pointsize 1.4 linecolor rgb word(tints,i) \
        title word(names,i).", friction 0", \
    for [i=1:3] data using (held(word(ways,i),0.3,"seconds")):(share(column("error"))) with points \
        pointtype int(word(marks,i))-1 pointsize 1.4 linewidth 2 linecolor rgb word(tints,i) \
        title word(names,i).", friction 0.3", \
    data using (front("seconds")):(share(column("error"))) with points pointtype 6 pointsize 2.4 \
        linewidth 2 linecolor rgb black title "front, of one friction", \
    data using (ours("seconds")):(share(column("error"))) with points pointtype 4 pointsize 3 \
        linewidth 2 linecolor rgb purple title "our defaults"
set title "Rest of all together: overlap that is left"
set ylabel "largest overlap [r]; none is 10^{-14}"
set yrange [1e-15:10]
set format y "10^{%T}"
set key inside top left
left(x) = x > 1e-14 ? x : 1e-14
plot for [i=1:3] data using (held(word(ways,i),0,"seconds")):(left(column("max_overlap"))) \
        with points pointtype int(word(marks,i)) pointsize 1.4 linecolor rgb word(tints,i) \
        title word(names,i).", friction 0", \
    for [i=1:3] data using (held(word(ways,i),0.3,"seconds")):(left(column("max_overlap"))) \
        with points pointtype int(word(marks,i))-1 pointsize 1.4 linewidth 2 \
        linecolor rgb word(tints,i) title word(names,i).", friction 0.3"
unset multiplot
