#include "pipeline/SameSheets.h"

#include "pipeline/StepInputs.h"
#include "project/Project.h"

namespace dipwright {

bool makeSameSheets(const Project& first, const Project& second) {
    if (first.immersions.size() != second.immersions.size()) {
        return false;
    }
    for (std::size_t number = 0; number < first.immersions.size(); ++number) {
        if (sheetInputs(first, {}, number, first.process.solver) !=
            sheetInputs(second, {}, number, second.process.solver)) {
            return false;
        }
    }
    return true;
}

} // namespace dipwright
