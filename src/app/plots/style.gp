# What all figures share. `name` is set by the script that loads this; `format` by whoever calls it:
#   gnuplot -e "format='svg'" NAME.gp
# draws NAME.svg, and without it NAME.png. Colours are from the Okabe-Ito palette, and every curve
# has a mark or dashes of its own besides.
if (!exists("format")) format = "png"
if (!exists("width")) width = 900
if (!exists("height")) height = 540
if (!exists("scale")) scale = 1.5
if (format eq "svg") {
    set terminal svg size width,height font "DejaVu Sans,15" background "#ffffff"
} else { if (format eq "pdf") {
    set terminal pdfcairo size width/96.0,height/96.0 font "DejaVu Sans,11"
} else {
    set terminal pngcairo size scale*width,scale*height font "DejaVu Sans,15" \
        fontscale 0.75*scale linewidth scale pointscale scale
} }
set output name.".".format
set encoding utf8
set datafile separator ","
set datafile columnheaders

blue = "#0072b2"
orange = "#e69f00"
green = "#009e73"
vermillion = "#d55e00"
purple = "#cc79a7"
sky = "#56b4e9"
black = "#202020"

set border 3 linecolor rgb "#606060"
set tics nomirror out textcolor rgb black
set format "%g"
set grid y linecolor rgb "#d8d8d8" linewidth 1
set key reverse Left samplen 2.5 textcolor rgb black
