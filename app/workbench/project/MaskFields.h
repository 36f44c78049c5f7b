// The fields that set what the next click or stroke on the body masks.
#pragma once

#include "workbench/widgets/MarkFields.h"

namespace dipwright {

class MaskFields : public MarkFields {
    Q_OBJECT

public:
    explicit MaskFields(LengthUnit unit, QWidget* parent = nullptr);

protected:
    MarkBrush chosen() const override;
};

} // namespace dipwright
