# Porosity along the axis, about it, and from the wall; bands are twice the error.
name = "porosity"
height = 420
width = 1200
load "style.gp"
set multiplot layout 1,3
unset key
tables = "height radial wall"
labels = "'height' 'distance from the axis' 'distance from the wall'"
at(from, to) = (column(from) + column(to)) / 2
do for [i=1:3] {
    set yrange [*:*]
    set xlabel word(labels, i)." [mesh unit]"
    set ylabel i == 1 ? "porosity" : ""
    # At most five ticks, whose numbers have room however small the unit makes them.
    stats "porosity_".word(tables, i).".csv" using "to" nooutput
    set yrange [0:1] # after stats, which leaves out values beyond it
    tick = 10 ** floor(log10(STATS_max / 4))
    share = STATS_max / 4 / tick
    set xtics tick * (share <= 1 ? 1 : share <= 2 ? 2 : share <= 5 ? 5 : 10)
    plot "porosity_".word(tables, i).".csv" \
        using (at("from", "to")):(column("porosity") - 2 * column("error")):\
        (column("porosity") + 2 * column("error")) with filledcurves \
        linecolor rgb sky fillstyle transparent solid 0.5 noborder, \
        "" using (at("from", "to")):"porosity" with lines linewidth 1.8 linecolor rgb blue
}
unset multiplot
