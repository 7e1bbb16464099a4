// Thousands of edits, pauses, restarts and captures in random order, and sessions closed at any moment. The
// thread sanitizer runs this test too (preset tsan).
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/fake_backend.h"

namespace glint {
namespace {

using test::FakeControl;
using test::fakeOptions;
using test::fakeScene;
using test::makeFakeBackend;

/// One random act of a restless user. `size` follows the resolution of the last good scene.
void act(RenderSession& session, FakeControl& control, std::mt19937& random, RenderRequest* request,
         int* size) {
    const auto pick = [&](int count) { return static_cast<int>(random() % static_cast<uint32_t>(count)); };
    switch (pick(14)) {
        case 0:
            request->paused = pick(2) == 0;
            session.request(*request);
            break;
        case 1:
            session.restart();
            break;
        case 2:
            request->interacting = pick(2) == 0;
            session.request(*request);
            break;
        case 3:
            request->aovs = pick(2) == 0 ? uint32_t{kAovAlbedo} : 0u;
            request->standardError = pick(2) == 0;
            session.request(*request);
            break;
        case 4:
            request->limits = {.passes = static_cast<uint32_t>(pick(4))};
            session.request(*request);
            break;
        case 5:
            *size = 1 + pick(20);
            session.post({fakeScene(*size, *size), EditKind::Resolution});
            break;
        case 6:
            *size = 1 + pick(20);
            session.post({fakeScene(*size, *size), EditKind::Everything});
            break;
        case 7:
            control.buildsFailing = pick(2);
            break;
        case 8:
            control.failPasses = pick(4) == 0;
            break;
        case 9:
            control.secondsPerPass = pick(2) * 0.0005;
            break;
        case 10:
            session.resume(fakeScene(*size, *size),
                           {.film = Film(*size, pick(8) == 0 ? *size + 1 : *size), .renderSeconds = 0.0});
            break;
        default:
            session.post({fakeScene(*size, *size), static_cast<EditKind>(1u << pick(8))});
            break;
    }
}

TEST(SessionStress, ThousandsOfRandomActsLeaveASessionThatWorks) {
    std::mt19937 random(1234);
    const auto control = std::make_shared<FakeControl>();
    RenderSession session(makeFakeBackend(control), fakeOptions(control));
    RenderRequest request;
    int size = 8;
    session.post({fakeScene(size, size), EditKind::Everything});
    std::vector<std::future<std::optional<SessionCapture>>> captures;
    EditTicket ticket = 0;
    for (int i = 0; i < 6000; ++i) {
        act(session, *control, random, &request, &size);
        if (const auto snapshot = session.snapshot()) {
            ASSERT_GE(snapshot->ticket, ticket) << "pictures of an older scene must not come back";
            ticket = snapshot->ticket;
            ASSERT_EQ(snapshot->radiance.size(), static_cast<size_t>(snapshot->width) * snapshot->height * 3);
        }
        if (i % 50 == 0) { captures.push_back(session.captureLater()); }
        if (i % 16 == 0) { std::this_thread::sleep_for(std::chrono::microseconds(300)); }
    }
    control->buildsFailing = 0;
    control->failPasses = false;
    control->secondsPerPass = 0.0;
    session.request({.limits = {.passes = 3}});
    session.post({fakeScene(5, 5), EditKind::Everything});
    ASSERT_EQ(session.wait(60.0), SessionState::Finished);
    for (auto& capture : captures) {
        capture.get();
    }
    const auto snapshot = session.snapshot();
    EXPECT_EQ(snapshot->width, 5);
    EXPECT_EQ(snapshot->passes, 3u);
    EXPECT_EQ(snapshot->ticket, session.status().ticket);
}

TEST(SessionStress, ClosesAtAnyMomentAndAnswersWaitingCaptures) {
    std::mt19937 random(99);
    for (int round = 0; round < 300; ++round) {
        const auto control = std::make_shared<FakeControl>();
        control->secondsPerPass = (round % 3) * 0.001;
        std::future<std::optional<SessionCapture>> capture;
        {
            RenderSession session(makeFakeBackend(control), fakeOptions(control));
            RenderRequest request;
            int size = 6;
            session.post({fakeScene(size, size), EditKind::Everything});
            const int acts = static_cast<int>(random() % 12);
            for (int i = 0; i < acts; ++i) {
                act(session, *control, random, &request, &size);
            }
            capture = session.captureLater();
            std::this_thread::sleep_for(std::chrono::microseconds(random() % 2000));
        }
        capture.get();  // A promise that nobody kept would throw here.
    }
}

}  // namespace
}  // namespace glint
