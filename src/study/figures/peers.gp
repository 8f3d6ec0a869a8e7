# Other engines beside ours: time against overlap, a point a run. Rings: the Pareto front.
name = "peers"
width = 1100
height = 640
load "style.gp"
floor = 1e-16
clip(x) = x > floor ? x : floor
on(curve, x) = strcol("engine") eq curve ? column(x) : NaN
theirs(x) = strcol("engine") eq "Frostfill" ? NaN : column(x)
front(x) = column("front") == 1 ? column(x) : NaN
restless(x) = column("at_rest") == 0 ? column(x) : NaN
set datafile missing NaN
set logscale xy
set format x "%g"
set format y "10^{%T}"
set xlabel "processor time [s], one thread"
set ylabel "largest overlap of spheres, or with the walls [r]"
set key outside right center
set yrange [1e-16:10]
data = "peers.csv"
# Engines that are not built in, by their names: each once, in quotes.
known(name) = strstrt("|Frostfill|Bullet|ODE|LIGGGHTS|", "|".name."|") > 0
quoted(name) = "'".name."' "
others = ""
mark(k) = int(word("11 15 12 10", 1 + (k - 1) % 4))
tint(k) = k % 2 ? purple : sky
collect(name) = (others = known(name) || strstrt(others, quoted(name)) > 0 ? others : others.quoted(name), 1)
stats data using (collect(strcol("engine"))) nooutput
plot data using (on("Frostfill","seconds")):(clip(on("Frostfill","worst"))) with points \
        pointtype 5 pointsize 1.6 linecolor rgb blue title "Frostfill", \
    data using (on("Bullet","seconds")):(clip(on("Bullet","worst"))) with points \
        pointtype 9 pointsize 1.8 linecolor rgb orange title "Bullet", \
    data using (on("ODE","seconds")):(clip(on("ODE","worst"))) with points \
        pointtype 13 pointsize 2 linecolor rgb green title "ODE", \
    data using (on("LIGGGHTS","seconds")):(clip(on("LIGGGHTS","worst"))) with points \
        pointtype 7 pointsize 1.6 linecolor rgb vermillion title "LIGGGHTS", \
    for [k=1:words(others)] data using (on(word(others,k),"seconds")):(clip(on(word(others,k),"worst"))) \
        with points pointtype mark(k) pointsize 1.8 linecolor rgb tint(k) \
        title word(others,k) noenhanced, \
    data using (restless("seconds")):(clip(restless("worst"))) with points pointtype 2 \
        pointsize 2.6 linewidth 2 linecolor rgb black title "not at rest at the end", \
    data using (front("seconds")):(clip(front("worst"))) with points pointtype 6 pointsize 2.8 \
        linewidth 2 linecolor rgb black title "Pareto front", \
    data using (on("Frostfill","seconds")):(clip(column("worst"))):(strcol("setting")) with labels \
        left offset 1.5,0 font ",10" notitle, \
    data using (theirs("seconds")):(clip(column("worst"))):(strcol("setting")) with labels \
        right offset -1.7,0 font ",10" notitle
