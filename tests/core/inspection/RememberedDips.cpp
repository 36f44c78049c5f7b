#include "RememberedDips.h"

#include <algorithm>

namespace dipwright::test {
namespace {

bool isSame(const solver::DipSetup& one, const solver::DipSetup& other) {
    const solver::BodyMotion &a = one.motion, &b = other.motion;
    return one.film == other.film && one.settings == other.settings && one.pinned == other.pinned &&
           a.rotation == b.rotation && a.start == b.start && a.travel == b.travel &&
           a.speed == b.speed;
}

} // namespace

bool RememberedDips::runBatch(std::span<solver::BatchItem> items, solver::CancelFunction cancelled,
                              void* context) const {
    const std::lock_guard lock(mutex_);
    const auto find = [this](const solver::BatchItem& item) {
        return std::find_if(known_.begin(), known_.end(), [&](const solver::BatchItem& known) {
            return isSame(known.setup, item.setup);
        });
    };
    std::vector<solver::BatchItem> unknown;
    for (const solver::BatchItem& item : items) {
        if (find(item) == known_.end()) {
            unknown.push_back(item);
        }
    }
    if (!module_.runBatch(unknown, cancelled, context)) {
        return false;
    }
    std::move(unknown.begin(), unknown.end(), std::back_inserter(known_));
    for (solver::BatchItem& item : items) {
        const solver::FieldView field = item.setup.field;
        item = *find(item);
        item.setup.field = field; // the caller owns the field
    }
    return true;
}

} // namespace dipwright::test
