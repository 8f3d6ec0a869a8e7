# (gnuplot takes no comma in quoted text, so there is none in the data.)
# The stress matrix: a row for what is varied, a cell for each value, a panel for each method.
name = "stability"
width = 1800
height = 1980
load "style.gp"
data = "stability.csv"
unset grid
unset key
set border 0
set tics scale 0
unset xtics
set format y "%s"
colour(code) = code == 0 ? 0xb9e3d3 : code == 1 ? 0xd7e3ee : code == 2 ? 0xf6e27a : \
    code == 3 ? 0xe69f00 : code == 4 ? 0xcc79a7 : code == 5 ? 0xd55e00 : code == 6 ? 0x202020 : \
    code == 7 ? 0x8c8c8c : code == 9 ? 0x56b4e9 : \
    code == 10 ? 0x0072b2 : 0xf4f4f4
ink(code) = code == 6 ? 0xffffff : code == 10 ? 0xffffff : code == 5 ? 0xffffff : 0x202020
methods = "'fast' 'fast skip' 'joint' 'grains' 'paper' 'paper semi-implicit'"
titles = "'fast' 'fast, from the first contact on' 'settling together, friction 0.3' 'grains, friction 0.6, rolling friction 0.1' 'paper (explicit Euler)' 'paper, semi-implicit Euler'"
is(method) = strcol("method") eq method
row(method) = is(method) ? -column("row") : NaN
mark(method) = is(method) ? strcol("value") : ""
remark(method) = is(method) ? strcol("note") : ""
stats data using "row" nooutput
rows = STATS_max + 1
set yrange [0.6-rows:0.6]
set xrange [-0.55:10.55]
names = "'passes' 'refused, saying why' 'gains energy' 'never rests' 'not reproducible' 'a centre outside' 'not finite' 'unfinished' 'not run (too long)' 'overlaps' 'hangs in the air'"
do for [k=0:10] {
    x = 0.11 + (k % 6) * 0.15
    y = k < 6 ? 0.029 : 0.012
    set object 100+k rectangle from screen x,screen y-0.005 to screen x+0.018,screen y+0.005 \
        fillcolor rgb colour(k) fillstyle solid border rgb "#a0a0a0"
    set label 100+k word(names, k+1) at screen x+0.024,screen y left font ",12.5"
}
set multiplot layout 3,2 margins 0.105,0.99,0.045,0.98 spacing 0.11,0.028
do for [i=1:6] {
    method = word(methods, i)
    set title word(titles, i) font ",16" offset 0,-0.6
    plot data using (-9):(-column("row")):ytic(stringcolumn("axis")) with points pointsize 0, \
         data using "column":(row(method)):(0.48):(0.46):(colour(column("code"))) \
             with boxxyerror fillstyle solid linewidth 0 \
             linecolor rgb variable, \
         data using "column":(row(method) + (strcol("note") eq "" ? 0 : 0.17)):(mark(method)):\
             (ink(column("code"))) with labels font ",9" textcolor rgb variable, \
         data using "column":(row(method) - 0.2):(remark(method)):(ink(column("code"))) \
             with labels font ",8" textcolor rgb variable
    if (i == 1) {
        do for [k=100:110] { unset object k; unset label k }
    }
}
unset multiplot
