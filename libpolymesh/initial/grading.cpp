// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/grading.h"

#include <algorithm>
#include <cmath>

namespace polymesh {
namespace {

double sum(const Grading& grading, double GradingSection::*share) {
    double total = 0;
    for (const GradingSection& section : grading)
        total += section.*share;
    return total;
}

/// The number of cells of each section.
std::vector<Label> sectionCells(Label cells, const Grading& grading) {
    const double total = sum(grading, &GradingSection::cells);
    std::vector<Label> result;
    Label left = cells;
    for (const GradingSection& section : grading) {
        const double share = section.cells / total * static_cast<double>(cells);
        result.push_back(static_cast<Label>(std::lround(share)));
        left -= result.back();
    }
    const auto largest = std::ranges::max_element(grading, {}, &GradingSection::cells);
    result[static_cast<std::size_t>(largest - grading.begin())] += left;
    return result;
}

/// The share of a section's length that its first i of n cells have; i may lie within a cell.
double sectionShare(double i, Label n, double expansion) {
    const double share = i / static_cast<double>(n);
    if (std::abs(expansion - 1) < 1e-15 || n == 1) return share;
    const double growth = std::pow(expansion, 1 / static_cast<double>(n - 1));
    const double numerator = 1 - std::pow(growth, i);
    return numerator / (1 - std::pow(growth, static_cast<double>(n)));
}

} // namespace

Grading reversed(const Grading& grading) {
    Grading result(grading.rbegin(), grading.rend());
    for (GradingSection& section : result)
        section.expansion = 1 / section.expansion;
    return result;
}

std::vector<double> gradedParameters(Label cells, const Grading& grading, Label parts) {
    std::vector<double> result{0};
    const bool even = grading.empty() || cells < toLabel(grading.size());
    const Grading& used = even ? Grading{{}} : grading;
    const double length = sum(used, &GradingSection::length);
    const std::vector<Label> counts = sectionCells(cells, used);
    for (std::size_t s = 0; s < used.size(); ++s) {
        const double start = result.back();
        for (Label i = 1; i <= counts[s] * parts; ++i) {
            const double cell = static_cast<double>(i) / static_cast<double>(parts);
            result.push_back(start + used[s].length / length *
                                         sectionShare(cell, counts[s], used[s].expansion));
        }
    }
    result.resize(index(cells * parts) + 1);
    result.back() = 1;
    return result;
}

} // namespace polymesh
