#include "player/preview/gl.h"

namespace ribbon {

namespace {

template <class Function>
bool find(const OffscreenContext& context, const char* name, Function& function) {
  function = reinterpret_cast<Function>(context.function(name));
  return function != nullptr;
}

bool find_all(const OffscreenContext& context, Gl& gl) {
  return find(context, "glAttachShader", gl.AttachShader) &&
         find(context, "glBindAttribLocation", gl.BindAttribLocation) &&
         find(context, "glBindBuffer", gl.BindBuffer) &&
         find(context, "glBindFramebuffer", gl.BindFramebuffer) &&
         find(context, "glBindRenderbuffer", gl.BindRenderbuffer) &&
         find(context, "glBindTexture", gl.BindTexture) &&
         find(context, "glBindVertexArray", gl.BindVertexArray) &&
         find(context, "glBlendFunc", gl.BlendFunc) &&
         find(context, "glBlitFramebuffer", gl.BlitFramebuffer) &&
         find(context, "glBufferData", gl.BufferData) &&
         find(context, "glCheckFramebufferStatus", gl.CheckFramebufferStatus) &&
         find(context, "glClear", gl.Clear) && find(context, "glCompileShader", gl.CompileShader) &&
         find(context, "glCreateProgram", gl.CreateProgram) &&
         find(context, "glCreateShader", gl.CreateShader) &&
         find(context, "glDeleteFramebuffers", gl.DeleteFramebuffers) &&
         find(context, "glDeleteRenderbuffers", gl.DeleteRenderbuffers) &&
         find(context, "glDeleteShader", gl.DeleteShader) &&
         find(context, "glDepthFunc", gl.DepthFunc) && find(context, "glDepthMask", gl.DepthMask) &&
         find(context, "glDisable", gl.Disable) &&
         find(context, "glDrawElements", gl.DrawElements) && find(context, "glEnable", gl.Enable) &&
         find(context, "glEnableVertexAttribArray", gl.EnableVertexAttribArray) &&
         find(context, "glFramebufferRenderbuffer", gl.FramebufferRenderbuffer) &&
         find(context, "glGenBuffers", gl.GenBuffers) &&
         find(context, "glGenerateMipmap", gl.GenerateMipmap) &&
         find(context, "glGenFramebuffers", gl.GenFramebuffers) &&
         find(context, "glGenRenderbuffers", gl.GenRenderbuffers) &&
         find(context, "glGenTextures", gl.GenTextures) &&
         find(context, "glGenVertexArrays", gl.GenVertexArrays) &&
         find(context, "glGetError", gl.GetError) &&
         find(context, "glGetProgramiv", gl.GetProgramiv) &&
         find(context, "glGetUniformLocation", gl.GetUniformLocation) &&
         find(context, "glLinkProgram", gl.LinkProgram) &&
         find(context, "glPixelStorei", gl.PixelStorei) &&
         find(context, "glReadPixels", gl.ReadPixels) &&
         find(context, "glRenderbufferStorageMultisample", gl.RenderbufferStorageMultisample) &&
         find(context, "glShaderSource", gl.ShaderSource) &&
         find(context, "glTexImage3D", gl.TexImage3D) &&
         find(context, "glTexParameteri", gl.TexParameteri) &&
         find(context, "glUniform1f", gl.Uniform1f) && find(context, "glUniform2f", gl.Uniform2f) &&
         find(context, "glUniform3fv", gl.Uniform3fv) &&
         find(context, "glUniform4fv", gl.Uniform4fv) &&
         find(context, "glUniformMatrix4fv", gl.UniformMatrix4fv) &&
         find(context, "glUseProgram", gl.UseProgram) &&
         find(context, "glVertexAttribPointer", gl.VertexAttribPointer) &&
         find(context, "glViewport", gl.Viewport);
}

}  // namespace

Result<Gl> load_gl(const OffscreenContext& context) {
  Gl gl{};
  if (find_all(context, gl)) return gl;
  return failure("--preview", "OSMesa lacks functions of OpenGL 3.3",
                 "install a newer OSMesa, or render without --preview");
}

}  // namespace ribbon
