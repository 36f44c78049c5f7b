// The raster image processor that a CMYK PDF is made for.
#pragma once

namespace dipwright {

// It decides how white and spot plates print over the other inks (ISO 32000-1, 8.6.7 and 11.7.4).
// A plate that overprints must not have a blend mode, too: other plates would then blend with
// themselves.
enum class PdfTarget {
    // The plates blend by Multiply, in a transparency group. Screens show them correctly, too.
    Ghostscript,
    // The plates overprint (OP, op, OPM 1), without transparency. Viewers that ignore overprinting
    // show white over the colours.
    AdobePrintEngine,
    // The same, for raster image processors that know no transparency and nothing after PDF 1.4:
    // PDF/X-1a instead of PDF/X-4.
    OlderRip
};

} // namespace dipwright
