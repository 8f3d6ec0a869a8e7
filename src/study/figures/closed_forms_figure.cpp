// SPDX-License-Identifier: MIT
#include "study/error/closed_forms.hpp"
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"

namespace frostfill
{
namespace
{

void makeClosedFormsData(const FigureFolder& folder)
{
    folder.write("closed-forms.csv", closedFormsCsv(measureClosedForms(folder.quick())));
}

} // namespace

Figure closedFormsFigure()
{
    return {"closed-forms",      "errors against closed forms", false, 1,
            makeClosedFormsData, embedded::figure_closed_forms};
}

} // namespace frostfill
