// Splits a search between several processes: each process dips one part, and one of them ranks all
// parts as if it had dipped them itself.
#pragma once

#include "base/Progress.h"
#include "search/SearchSubject.h"
#include "settings/SearchSettings.h"

#include <memory>

namespace dipwright {

struct JudgedPose;

// One part of a search.
struct SearchShard {
    QByteArray key; // identifies the search: its subject and settings
    // Number of this part, from 1, and number of all parts.
    int number = 1, count = 1;
    std::vector<std::shared_ptr<const JudgedPose>> poses; // in the order of dipping
};

// Dips part `number` of a search. The part holds every `count`-th dip of the first
// stage of searchPoses(). `number` is 1 … `count`; `count` is at most 1000. Throws as searchPoses()
// does; after Cancelled there is no result.
SearchShard searchShard(const SearchSubject& subject, const SearchSettings& settings,
                        const solver::SolverModule& module, int number, int count,
                        const Progress& progress);

// Returns the bytes of a part's file, without loss.
QByteArray shardFile(const SearchShard& part);
// Reads a part from its file. Throws Error naming `where` if the file is not a part.
SearchShard shardFromFile(const QByteArray& file, const QString& where);

} // namespace dipwright
