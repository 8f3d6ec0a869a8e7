# The mean radius by height and by the distance from the axis; bars are the standard deviation.
name = "sizes"
height = 420
width = 1200
load "style.gp"
set multiplot layout 1,2
unset key
tables = "height radial"
labels = "'height' 'distance from the axis'"
do for [i=1:2] {
    set xlabel word(labels, i)." [mesh unit]"
    set ylabel i == 1 ? "mean radius [mesh unit]" : ""
    plot "sizes_".word(tables, i).".csv" \
        using ((column("from") + column("to")) / 2):"mean_radius":"deviation" \
        with yerrorbars pointtype 7 pointsize 0.7 linewidth 1.4 linecolor rgb blue
}
unset multiplot
