// Fields in which the user chooses what the next click on the body marks: the dip that paints the
// place, or whether the seam may run there.
#pragma once

#include "workbench/widgets/MarkFields.h"

class QCheckBox;

namespace dipwright {

class SeamFields : public MarkFields {
    Q_OBJECT

public:
    explicit SeamFields(LengthUnit unit, QWidget* parent = nullptr);

    void setDips(const QString& first, const QString& second); // names of the two dips

protected:
    MarkBrush chosen() const override;

private:
    QCheckBox* face_;
};

} // namespace dipwright
