#include "workbench/dip/LiveRun.h"

#include "pipeline/SameSheets.h"

namespace dipwright {

LiveRun::LiveRun(QObject* parent) : QObject(parent) {
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &LiveRun::runAsked);
}

void LiveRun::setDocument(const Document* document) {
    soon_.stop();
    cancelled_.reset();
    held_ = begun_ = false;
    document_ = document;
    if (document) {
        connect(document, &Document::projectChanged, this, &LiveRun::consider);
    }
}

void LiveRun::begin() {
    soon_.stop();
    cancelled_.reset();
    begun_ = true;
}

void LiveRun::cancel() {
    soon_.stop();
    if (document_) {
        cancelled_ = document_->project();
    }
}

void LiveRun::setHeld(bool held) {
    held_ = held;
    consider();
}

void LiveRun::consider() {
    if (!wanted_ || !document_ || !(begun_ || document_->result()) || document_->isFresh()) {
        return;
    }
    if (!cancelled_ || !makeSameSheets(*cancelled_, document_->project())) {
        soon_.start();
    }
}

} // namespace dipwright
