// A share of a search's dips, made by one process of several: every process dips its part, and one
// of them ranks all parts as if it had dipped them itself.
#pragma once

#include "base/Progress.h"
#include "search/SearchSubject.h"
#include "settings/SearchSettings.h"

#include <memory>

namespace dipwright {

struct JudgedPose;

struct SearchShard {
    QByteArray key; // of the search: its subject and settings
    int number = 1, count = 1;
    std::vector<std::shared_ptr<const JudgedPose>> poses; // in the order in which they are dipped
};

// Part `number`, 1 … count (at most 1000), of searchPoses(): every count-th of its first dips.
// Throws as searchPoses() does; Cancelled leaves nothing.
SearchShard searchShard(const SearchSubject& subject, const SearchSettings& settings,
                        const solver::SolverModule& module, int number, int count,
                        const Progress& progress);

// As a file, and back: exactly the same. Throws Error naming `where` for what is no such file.
QByteArray shardFile(const SearchShard& part);
SearchShard shardFromFile(const QByteArray& file, const QString& where);

} // namespace dipwright
