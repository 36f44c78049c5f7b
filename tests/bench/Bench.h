// Provides command-line arguments and clocks for the programs that measure.
#pragma once

#include "cli/bench/Statistics.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace dipwright::bench {

using cli::secondsOf;
using cli::Statistics;
using cli::statistics;
using cli::timed;

struct Elapsed {
    double seconds = 0;    // wall time
    double processors = 0; // seconds of all processors, added up
};

template <typename Work>
Elapsed elapsed(const Work& work) {
    const std::clock_t start = std::clock();
    const double seconds = secondsOf(work);
    return {seconds, double(std::clock() - start) / CLOCKS_PER_SEC};
}

// The numbers of columns and rows of the films in the paper's Table I.
using Sizes = std::vector<std::pair<int, int>>;
inline const Sizes tableOneFilms{{8, 12},    {40, 60},   {80, 120},  {120, 180},
                                 {160, 240}, {200, 300}, {240, 360}, {280, 420}};

// Splits the command line into NAME=VALUE arguments, in any order, and other words.
class Arguments {
public:
    Arguments(int argc, char** argv) {
        for (const std::string& word : std::vector<std::string>(argv + 1, argv + argc)) {
            if (const std::size_t sign = word.find('='); sign == std::string::npos) {
                words_.push_back(word);
            } else {
                values_[word.substr(0, sign)] = word.substr(sign + 1);
            }
        }
    }

    const std::map<std::string, std::string>& values() const { return values_; }
    std::string value(const std::string& name, std::string otherwise = {}) const {
        const auto given = values_.find(name);
        return given == values_.end() ? std::move(otherwise) : given->second;
    }
    int number(const std::string& name, int otherwise) const {
        return std::atoi(value(name, std::to_string(otherwise)).c_str());
    }

    // Returns the remaining words in their order.
    const std::vector<std::string>& words() const { return words_; }
    // Removes a word and returns true; returns false if it is not among the words.
    bool take(const std::string& word) { return std::erase(words_, word) > 0; }
    // Removes words such as 120x180 and returns the sizes that they name, or `otherwise` if there
    // are none.
    Sizes takeSizes(Sizes otherwise) {
        Sizes sizes;
        std::erase_if(words_, [&](const std::string& word) {
            int columns = 0, rows = 0;
            const bool isSize = std::sscanf(word.c_str(), "%dx%d", &columns, &rows) == 2;
            if (isSize) {
                sizes.emplace_back(columns, rows);
            }
            return isSize;
        });
        return sizes.empty() ? std::move(otherwise) : sizes;
    }

private:
    std::map<std::string, std::string> values_;
    std::vector<std::string> words_;
};

} // namespace dipwright::bench
