#include "cpu/PaperKernels.h"

namespace dipwright::cpu {

PaperKernels vectorPaperKernels() {
    return scalarPaperKernels();
}

} // namespace dipwright::cpu
