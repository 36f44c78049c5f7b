// Splits a search between several processes. Each process simulates the dips of one shard, and one
// of them ranks the dips of all shards as if it had simulated them itself.
#pragma once

#include "base/Progress.h"
#include "search/SearchSubject.h"
#include "settings/SearchSettings.h"

#include <memory>

namespace dipwright {

struct JudgedPose;

// One shard of a search.
struct SearchShard {
    QByteArray key; // identifies the search: its subject and settings
    // Number of this shard, from 1, and the total number of shards.
    int number = 1, count = 1;
    std::vector<std::shared_ptr<const JudgedPose>> poses; // in the order of dipping
};

// Simulates the dips of shard `number` of a search. It holds every `count`-th dip of the first
// stage of searchPoses(). `number` is 1 … `count`; `count` is at most 1000. Throws as searchPoses()
// does; after Cancelled there is no result.
SearchShard searchShard(const SearchSubject& subject, const SearchSettings& settings,
                        const solver::SolverModule& module, int number, int count,
                        const Progress& progress);

// Returns the bytes of a shard's file, without loss.
QByteArray shardFile(const SearchShard& shard);
// Whether a file begins as shardFile() does.
bool isShardFile(const QByteArray& file);
// Reads a shard from its file. Throws Error naming `where` if the file is not a shard.
SearchShard shardFromFile(const QByteArray& file, const QString& where);

} // namespace dipwright
