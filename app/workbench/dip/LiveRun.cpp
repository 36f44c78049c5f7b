#include "workbench/dip/LiveRun.h"

#include "pipeline/SameSheets.h"

namespace dipwright {

namespace {

constexpr int delayAfterChange = 350; // ms

} // namespace

LiveRun::LiveRun(QObject* parent) : QObject(parent) {
    delay_.setSingleShot(true);
    delay_.setInterval(delayAfterChange);
    connect(&delay_, &QTimer::timeout, this, &LiveRun::runAsked);
}

void LiveRun::setDocument(const Document* document) {
    stop();
    held_ = false;
    document_ = document;
    if (document) {
        connect(document, &Document::projectChanged, this, &LiveRun::consider);
    }
}

void LiveRun::stop() {
    delay_.stop();
    cancelled_.reset();
}

void LiveRun::cancel() {
    stop();
    if (document_) {
        cancelled_ = document_->project();
    }
}

void LiveRun::setHeld(bool held) {
    held_ = held;
    consider();
}

void LiveRun::consider() {
    if (!wanted_ || held_ || !document_ || !document_->result() || document_->isFresh()) {
        return;
    }
    if (!cancelled_ || !makeSameSheets(*cancelled_, document_->project())) {
        delay_.start();
    }
}

} // namespace dipwright
