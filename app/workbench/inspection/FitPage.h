// The page on which film and dip are fitted to what photos of a dipped part show.
#pragma once

#include "inspection/FilmFitFiles.h"

#include <QWidget>
#include <memory>

class QLabel;
class QPushButton;
class QTableWidget;

namespace dipwright {

// What was found, and of what.
struct FittedPart {
    FitPairs pairs;
    std::vector<FittedPhoto> photos;
    FilmFit fit;
};

class FitPage : public QWidget {
    Q_OBJECT

public:
    explicit FitPage(QWidget* parent = nullptr);

    // Whether there are places of the print to fit to, and whether places of the body besides.
    void setReady(bool ready, bool hasBody);
    // Null: nothing was fitted, or something has changed since. `isUsed`: the project has it.
    void setFitted(std::shared_ptr<const FittedPart> fitted, bool isUsed);
    void setRefusal(const QString& sentence); // instead of a fit
    void setBusy(bool busy);

signals:
    void fitAsked();
    void useAsked();
    void saveAsked();
    void exportAsked();

private:
    QWidget* makeButtons();
    void showQuantities();
    void showCorrelations();
    void enable();
    void say();

    std::shared_ptr<const FittedPart> fitted_;
    QString refusal_;
    bool ready_ = false, hasBody_ = false, busy_ = false, isUsed_ = false;
    QLabel *hint_, *words_;
    QPushButton *fit_, *use_, *save_, *export_;
    QTableWidget *quantities_, *correlations_;
};

} // namespace dipwright
