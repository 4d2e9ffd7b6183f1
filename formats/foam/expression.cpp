// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/expression.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fast_float/fast_float.h>
#include <numbers>
#include <span>
#include <string>
#include <vector>

namespace polymesh::foam {
namespace {

constexpr int deepest = 100; // nested parentheses

/// A number, and whether C++ would take it for an int.
struct Number {
    double value = 0;
    bool isWhole = false;
};

struct Function {
    std::string_view name;
    std::size_t arguments;
    double (*of)(double, double); // a function of one argument ignores the second
};

constexpr std::array functions{
    Function{"sqrt", 1, [](double x, double) { return std::sqrt(x); }},
    Function{"cbrt", 1, [](double x, double) { return std::cbrt(x); }},
    Function{"sqr", 1, [](double x, double) { return x * x; }},
    Function{"mag", 1, [](double x, double) { return std::abs(x); }},
    Function{"abs", 1, [](double x, double) { return std::abs(x); }},
    Function{"fabs", 1, [](double x, double) { return std::abs(x); }},
    Function{"exp", 1, [](double x, double) { return std::exp(x); }},
    Function{"log", 1, [](double x, double) { return std::log(x); }},
    Function{"log10", 1, [](double x, double) { return std::log10(x); }},
    Function{"sin", 1, [](double x, double) { return std::sin(x); }},
    Function{"cos", 1, [](double x, double) { return std::cos(x); }},
    Function{"tan", 1, [](double x, double) { return std::tan(x); }},
    Function{"asin", 1, [](double x, double) { return std::asin(x); }},
    Function{"acos", 1, [](double x, double) { return std::acos(x); }},
    Function{"atan", 1, [](double x, double) { return std::atan(x); }},
    Function{"sinh", 1, [](double x, double) { return std::sinh(x); }},
    Function{"cosh", 1, [](double x, double) { return std::cosh(x); }},
    Function{"tanh", 1, [](double x, double) { return std::tanh(x); }},
    Function{"floor", 1, [](double x, double) { return std::floor(x); }},
    Function{"ceil", 1, [](double x, double) { return std::ceil(x); }},
    Function{"round", 1, [](double x, double) { return std::round(x); }},
    Function{"degToRad", 1, [](double x, double) { return x / 180 * std::numbers::pi; }},
    Function{"radToDeg", 1, [](double x, double) { return x * 180 / std::numbers::pi; }},
    Function{"pow", 2, [](double x, double y) { return std::pow(x, y); }},
    Function{"atan2", 2, [](double x, double y) { return std::atan2(x, y); }},
    Function{"hypot", 2, [](double x, double y) { return std::hypot(x, y); }},
    Function{"fmod", 2, [](double x, double y) { return std::fmod(x, y); }},
    Function{"min", 2, [](double x, double y) { return std::min(x, y); }},
    Function{"max", 2, [](double x, double y) { return std::max(x, y); }}};

bool isLetter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Recursive descent: sum, product, sign, atom.
class Evaluation {
public:
    Evaluation(std::string_view text, const Variables& variables, const Place& place)
        : text_(text), variables_(variables), place_(place) {}

    double result(Division division) {
        division_ = division;
        const Number number = sum();
        if (at_ != text_.size()) fail(fmt::format("'{}' is not expected", text_.substr(at_)));
        if (!std::isfinite(number.value)) fail("the result is no finite number");
        return number.value;
    }

private:
    [[noreturn]] void fail(const std::string& problem) const {
        throw InputError(fmt::format("{}: the expression '{}': {}", place_.text(), text_, problem));
    }

    char look() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
            ++at_;
        return at_ < text_.size() ? text_[at_] : '\0';
    }

    bool take(char c) {
        if (look() != c) return false;
        ++at_;
        return true;
    }

    Number sum();
    Number product();
    Number sign();
    Number atom();
    Number literal();
    Number variable();
    Number named();
    Number call(const Function& function);
    Number quotient(const Number& a, const Number& b) const;

    std::string_view text_;
    const Variables& variables_;
    const Place& place_;
    Division division_ = Division::exact;
    std::size_t at_ = 0;
    int depth_ = 0;
};

Number Evaluation::sum() {
    Number left = product();
    while (true) {
        const char c = look();
        if (c != '+' && c != '-') return left;
        ++at_;
        const Number right = product();
        left = {c == '+' ? left.value + right.value : left.value - right.value,
                left.isWhole && right.isWhole};
    }
}

Number Evaluation::product() {
    Number left = sign();
    while (true) {
        const char c = look();
        if (c != '*' && c != '/' && c != '%') return left;
        ++at_;
        const Number right = sign();
        const bool whole = left.isWhole && right.isWhole;
        if (c == '*') left = {left.value * right.value, whole};
        if (c == '/') left = quotient(left, right);
        if (c == '%') left = {std::fmod(left.value, right.value), whole};
    }
}

Number Evaluation::quotient(const Number& a, const Number& b) const {
    if (b.value == 0) fail("division by zero");
    const bool whole = division_ == Division::whole && a.isWhole && b.isWhole;
    return {whole ? std::trunc(a.value / b.value) : a.value / b.value, whole};
}

Number Evaluation::sign() {
    if (++depth_ > deepest) fail("too many nested parts");
    Number number;
    if (take('-')) {
        number = sign();
        number.value = -number.value;
    } else if (take('+')) {
        number = sign();
    } else {
        number = atom();
    }
    --depth_;
    return number;
}

Number Evaluation::atom() {
    const char c = look();
    if (take('(')) {
        const Number inner = sum();
        if (!take(')')) fail("a ) is missing");
        return inner;
    }
    if (c == '$') return variable();
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.') return literal();
    if (isLetter(c)) return named();
    fail(c == '\0' ? "something is missing at the end" : fmt::format("'{}' is not expected", c));
}

Number Evaluation::literal() {
    Number number;
    const char* const begin = text_.data() + at_;
    const auto [stop, problem] =
        fast_float::from_chars(begin, text_.data() + text_.size(), number.value);
    if (problem != std::errc{}) fail("a number is malformed");
    const std::string_view written(begin, static_cast<std::size_t>(stop - begin));
    number.isWhole = written.find_first_of(".eE") == std::string_view::npos;
    at_ += written.size();
    return number;
}

Number Evaluation::variable() {
    ++at_;
    const bool braced = at_ < text_.size() && text_[at_] == '{';
    if (braced) ++at_;
    const std::size_t first = at_;
    while (at_ < text_.size() && (isLetter(text_[at_]) || text_[at_] == '.' || text_[at_] == ':'))
        ++at_;
    const std::string_view name = text_.substr(first, at_ - first);
    if (braced && !take('}')) fail("a } is missing");
    const std::optional<double> value = variables_(name);
    if (!value) fail(fmt::format("${} is no number that stands before this line", name));
    return {*value, *value == std::floor(*value)};
}

Number Evaluation::named() {
    const std::size_t first = at_;
    while (at_ < text_.size() && (isLetter(text_[at_]) || text_[at_] == ':'))
        ++at_;
    std::string_view name = text_.substr(first, at_ - first);
    for (const std::string_view space :
         {"Foam::", "std::", "constant::mathematical::", "constant::", "mathematical::"})
        if (name.starts_with(space)) name.remove_prefix(space.size());
    if (name == "pi" || name == "e") {
        if (take('(') && !take(')')) fail("a ) is missing");
        return {name == "pi" ? std::numbers::pi : std::numbers::e, false};
    }
    const auto found = std::ranges::find(functions, name, &Function::name);
    if (found == functions.end()) fail(fmt::format("'{}' is not supported", name));
    return call(*found);
}

Number Evaluation::call(const Function& function) {
    std::array<double, 2> arguments{};
    if (!take('(')) fail(fmt::format("{} needs ( )", function.name));
    for (std::size_t i = 0; i < function.arguments; ++i) {
        if (i > 0 && !take(',')) fail(fmt::format("{} needs two arguments", function.name));
        arguments[i] = sum().value;
    }
    if (!take(')')) fail(fmt::format("{}: a ) is missing", function.name));
    return {function.of(arguments[0], arguments[1]), false};
}

} // namespace

double evaluateExpression(std::string_view text,
                          const Variables& variables,
                          const Place& place,
                          Division division) {
    return Evaluation(text, variables, place).result(division);
}

} // namespace polymesh::foam
