# Operations a time step while groups of ten freeze one after another (torus): lines are the paper's
# lemmas, marks what was counted, at every eighth group.
name = "operations"
height = 560
load "style.gp"
data = "operations.csv"
at(discards, x) = column("discards") == discards ? column(x) : NaN
marked(discards, x) = int(column("beta")) % 8 == 0 ? at(discards, x) : NaN
set xlabel "spheres present"
set xtics format "%.0f"
set xtics 500
set multiplot layout 1,2 margins 0.09,0.975,0.38,0.93 spacing 0.13
set logscale y
set format y "10^{%T}"
set title "Sphere–sphere" font ",16"
set ylabel "operations a step"
set key at screen 0.3,0.01 center bottom maxcols 1
plot data using "spheres":(at(0, "tests_without_freezing")) with lines dashtype 3 linewidth 2 \
        linecolor rgb black title "tests with nothing frozen, n(n-1)/2", \
    data using "spheres":(at(0, "sphere_tests_lemma")) with lines linewidth 2 \
        linecolor rgb vermillion title "tests with freezing, Lemma 1", \
    data using "spheres":(marked(0, "sphere_tests")) with points pointtype 7 pointsize 0.8 \
        linecolor rgb vermillion title "counted", \
    data using "spheres":(at(1, "sphere_tests_lemma")) with lines linewidth 2 dashtype 2 \
        linecolor rgb blue title "tests with discards, Lemma 1", \
    data using "spheres":(marked(1, "sphere_tests")) with points pointtype 5 pointsize 0.8 \
        linecolor rgb blue title "counted", \
    data using "spheres":(marked(1, "sphere_responses_greatest")) with points pointtype 9 \
        pointsize 0.9 linecolor rgb green title "most responses in a step"
unset logscale y
set title "Sphere–polygon"
set format y "%.1f"
set ylabel "tests so far, one step a set [million]"
set key at screen 0.78,0.09 center bottom maxcols 1
plot data using "spheres":(at(0, "polygon_tests_so_far_lemma") / 1e6) with lines linewidth 2 \
        linecolor rgb vermillion title "no discards, Lemma 3: nm", \
    data using "spheres":(marked(0, "polygon_tests_so_far") / 1e6) with points pointtype 7 \
        pointsize 0.8 linecolor rgb vermillion title "counted", \
    data using "spheres":(at(1, "polygon_tests_so_far_lemma") / 1e6) with lines linewidth 2 \
        dashtype 2 linecolor rgb blue title "discards, Lemma 3", \
    data using "spheres":(marked(1, "polygon_tests_so_far") / 1e6) with points pointtype 5 \
        pointsize 0.8 linecolor rgb blue title "counted"
unset multiplot
