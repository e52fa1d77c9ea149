#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// The monomials of a full quadratic in the coded factors.
namespace asperity {

/// 1, x_i, x_i x_j or x_i^2; factors from 0, -1 for none.
struct Term {
  int first = -1, second = -1;
  bool operator==(const Term&) const = default;
};

enum class TermKind { constant, linear, interaction, square };

TermKind kind_of(Term term);

/// "1", "x1", "x1x2", "x1^2".
std::string term_name(Term term);

/// The monomial at coded levels x.
double term_value(Term term, std::span<const double> x);

/// Its derivative by the factor.
double term_derivative(Term term, std::span<const double> x, int factor);

/// All terms of Eq. (S3), (k + 1)(k + 2)/2 of them: constant, linear, interactions, squares, each in order of factors.
std::vector<Term> quadratic_terms(std::size_t factors);

/// Whether the linear `lower` is a factor of the interaction or square `higher`.
bool is_parent(Term lower, Term higher);

}  // namespace asperity
