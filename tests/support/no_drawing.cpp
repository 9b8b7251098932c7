#include "support/no_drawing.h"

#include <glad/gl.h>

#include <vector>

namespace timeshade {

namespace {

/// The functions that make a driver finish a program. Exchanged for those below, and back.
struct Functions {
    PFNGLDISPATCHCOMPUTEPROC dispatchCompute;
    PFNGLDRAWARRAYSPROC drawArrays;
    PFNGLDRAWARRAYSINSTANCEDPROC drawArraysInstanced;
    PFNGLDRAWELEMENTSPROC drawElements;
    PFNGLDRAWELEMENTSBASEVERTEXPROC drawElementsBaseVertex;
    PFNGLMULTIDRAWARRAYSPROC multiDrawArrays;
    PFNGLMULTIDRAWELEMENTSPROC multiDrawElements;
    PFNGLNAMEDBUFFERSTORAGEPROC namedBufferStorage;
};

Functions exchange(const Functions& f) {
    const Functions before{
        glad_glDispatchCompute,        glad_glDrawArrays,      glad_glDrawArraysInstanced, glad_glDrawElements,
        glad_glDrawElementsBaseVertex, glad_glMultiDrawArrays, glad_glMultiDrawElements,   glad_glNamedBufferStorage};
    glad_glDispatchCompute = f.dispatchCompute;
    glad_glDrawArrays = f.drawArrays;
    glad_glDrawArraysInstanced = f.drawArraysInstanced;
    glad_glDrawElements = f.drawElements;
    glad_glDrawElementsBaseVertex = f.drawElementsBaseVertex;
    glad_glMultiDrawArrays = f.multiDrawArrays;
    glad_glMultiDrawElements = f.multiDrawElements;
    glad_glNamedBufferStorage = f.namedBufferStorage;
    return before;
}

Functions real;

const Functions nothing{
    [](GLuint, GLuint, GLuint) {},
    [](GLenum, GLint, GLsizei) {},
    [](GLenum, GLint, GLsizei, GLsizei) {},
    [](GLenum, GLsizei, GLenum, const void*) {},
    [](GLenum, GLsizei, GLenum, const void*, GLint) {},
    [](GLenum, const GLint*, const GLsizei*, GLsizei) {},
    [](GLenum, const GLsizei*, GLenum, const void* const*, GLsizei) {},
    [](GLuint buffer, GLsizeiptr size, const void* data, GLbitfield flags) {
        // Counts that nothing writes are read as 0.
        const std::vector<char> zeros(data == nullptr ? static_cast<std::size_t>(size) : 0);
        real.namedBufferStorage(buffer, size, data == nullptr ? zeros.data() : data, flags);
    },
};

}  // namespace

NoDrawing::NoDrawing() { real = exchange(nothing); }
NoDrawing::~NoDrawing() { exchange(real); }

}  // namespace timeshade
