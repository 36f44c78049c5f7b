// Makes the proof to share with a customer (docs/proof.md).
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"

namespace dipwright {

struct SharedProof {
    QByteArray glb, html; // proof.glb and proof.html
};

// Makes both files from a finished result, in the program's language, without prices. Uses all
// cores. Equal results give equal bytes. Throws Error if the program was built without the page's
// viewer. Throws Cancelled.
SharedProof sharedProof(const JobResult& result, const Progress& progress);

} // namespace dipwright
