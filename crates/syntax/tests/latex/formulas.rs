//! A hundred formulas of the field. Beside each print stand the setting and the tree that is meant, written by hand before
//! the reader was run; `-` means that the print has no reading here, with the reason.

use crate::normal::{normal, normal_text};
use torse_syntax::derivation::{latex_names, question};
use torse_syntax::latex::read_latex;

/// Print, setting, meaning.
const FORMULAS: &[(&str, &str, &str)] = &[
    // Bernstein polynomials
    (
        r"B_i^n(t) = \binom{n}{i} t^i (1-t)^{n-i}",
        "n in 0..; i in 0..n; B(i, n, t) := t; t in [0, 1]",
        "B(i, n, t) == binom(n, i)*t^i*(1 - t)^(n - i)",
    ),
    (
        r"\sum_{i=0}^n B_i^n(t) = 1",
        "n in 0..; B(i, n, t) := t",
        "sum(i, 0, n, B(i, n, t)) == 1",
    ),
    (
        r"B_{i}^{n}(t)=(1-t)B_{i}^{n-1}(t)+tB_{i-1}^{n-1}(t),\quad 0\le t\le 1",
        "n in 1..; i in 0..n; B(i, n, t) := t",
        "B(i, n, t) == (1 - t)*B(i, n - 1, t) + t*B(i - 1, n - 1, t)",
    ),
    (
        r"\frac{d}{dt} B_i^n(t) = n\left(B_{i-1}^{n-1}(t) - B_i^{n-1}(t)\right)",
        "n in 1..; i in 0..n; B(i, n, t) := t",
        "D(B(i, n, t), t) == n*(B(i - 1, n - 1, t) - B(i, n - 1, t))",
    ),
    (
        r"B_{i,n}(u) = \frac{n!}{i!(n-i)!}u^i(1-u)^{n-i}",
        "n in 0..; i in 0..n; B(i, n, u) := u",
        "B(i, n, u) == factorial(n)/(factorial(i)*factorial(n - i))*u^i*(1 - u)^(n - i)",
    ),
    (
        r"\int_0^1 B_i^n(t)\,dt = \frac{1}{n+1}",
        "n in 0..; i in 0..n; B(i, n, t) := t",
        "integral(B(i, n, t), t, 0, 1) == 1/(n + 1)",
    ),
    (
        r"B_i^n(t)B_j^m(t)=\frac{\binom{n}{i}\binom{m}{j}}{\binom{n+m}{i+j}}B_{i+j}^{n+m}(t)",
        "n, m, i, j in 0..; B(i, n, t) := t",
        "B(i, n, t)*B(j, m, t) == binom(n, i)*binom(m, j)/binom(n + m, i + j)*B(i + j, n + m, t)",
    ),
    (
        r"\sum_{i=0}^{n} \frac{i}{n} B_i^n(t) = t",
        "n in 1..; B(i, n, t) := t",
        "sum(i, 0, n, i/n*B(i, n, t)) == t",
    ),
    // Bezier curves
    (
        r"\mathbf{C}(t)=\sum_{i=0}^{n}\mathbf{P}_i B_{i,n}(t)",
        "n in 0..; B(i, n, t) := t; P: vector 3; C: function 3",
        "-",
    ),
    (
        r"\mathbf{b}_0^1 = (1-t)\mathbf{b}_0+t\mathbf{b}_1",
        "b_0_1: vector 3; b_0: vector 3; b_1: vector 3",
        "-",
    ),
    (
        r"\mathbf{b}''(0) = n(n-1)(\mathbf{b}_2 - 2\mathbf{b}_1 + \mathbf{b}_0)",
        "n in 0..; b: function 3; b0: vector 3; b1: vector 3; b2: vector 3",
        "b''(0) == n*(n - 1)*(b2 - 2*b1 + b0)",
    ),
    (
        r"\dot{\mathbf{c}}(t) \cdot \mathbf{n} = 0",
        "c: function 3; n: vector 3",
        "dot(c'(t), n) == 0",
    ),
    (
        r"\mathbf{r}(u) = (1-u)^2\mathbf{p}_0+2u(1-u)\mathbf{p}_1+u^2\mathbf{p}_2",
        "r: function 3; p_0: vector 3; p_1: vector 3; p_2: vector 3",
        "r(u) == (1 - u)^2*p_0 + 2*u*(1 - u)*p_1 + u^2*p_2",
    ),
    (
        r"\mathbf r(t)=\frac{w_0(1-t)^2\mathbf p_0+2w_1t(1-t)\mathbf p_1+w_2t^2\mathbf p_2}{w_0(1-t)^2+2w_1t(1-t)+w_2t^2}",
        "r: function 3; p0: vector 3; p1: vector 3; p2: vector 3; w0, w1, w2 in (0, inf)",
        "r(t) == (w0*(1 - t)^2*p0 + 2*w1*t*(1 - t)*p1 + w2*t^2*p2)/(w0*(1 - t)^2 + 2*w1*t*(1 - t) + w2*t^2)",
    ),
    (
        r"k = \frac{w_0 w_2}{w_1^2}",
        "w0, w1, w2 in (0, inf)",
        "k == w0*w2/w1^2",
    ),
    (
        r"\Delta P_i = P_{i+1}-P_i",
        "Delta: vector 3; P: vector 3",
        "-",
    ),
    (
        r"\kappa(0)=\frac{n-1}{n}\frac{h}{a^2}",
        "n in 1..; kappa: function 1",
        "kappa(0) == (n - 1)/n*(h/a^2)",
    ),
    // splines
    (
        r"N_{i,k}(u)=\frac{u-u_i}{u_{i+k}-u_i}N_{i,k-1}(u)+\frac{u_{i+k+1}-u}{u_{i+k+1}-u_{i+1}}N_{i+1,k-1}(u)",
        "N(i, k, u) := u; i, k in 0..",
        "-",
    ),
    (
        r"N_{i,p}(x)=\frac{x-t_i}{t_{i+p}-t_i}N_{i,p-1}(x)+\frac{t_{i+p+1}-x}{t_{i+p+1}-t_{i+1}}N_{i+1,p-1}(x)",
        "N(i, p, x) := x; t[i] := i; i, p in 0..",
        "N(i, p, x) == (x - t[i])/(t[i+p] - t[i])*N(i, p - 1, x) + (t[i+p+1] - x)/(t[i+p+1] - t[i+1])*N(i + 1, p - 1, x)",
    ),
    (r"\sum_{j} N_{j,k}(u)=1", "N(i, k, u) := u; k in 0..", "-"),
    (
        r"N_0(u) = \frac{1}{6}(1-u)^3,\; N_3(u) = \frac{u^3}{6}",
        "N_0: function 1; N_3: function 1",
        "N_0(u) == 1/6*(1 - u)^3 and N_3(u) == u^3/6",
    ),
    (
        r"\alpha_i = \frac{\bar u - u_i}{u_{i+k}-u_i}",
        "alpha[i] := i; t[i] := i; u_bar in (0, 1); i, k in 0..",
        "-",
    ),
    // curvature and torsion
    (
        r"\kappa=\frac{\|\dot{\mathbf x}\times\ddot{\mathbf x}\|}{\|\dot{\mathbf x}\|^3}",
        "x: function 3",
        "-",
    ),
    (
        r"\kappa(t)=\frac{\|\mathbf r'(t)\times\mathbf r''(t)\|}{\|\mathbf r'(t)\|^3}",
        "kappa: function 1; r: function 3",
        "kappa(t) == norm(cross(r'(t), r''(t)))/norm(r'(t))^3",
    ),
    (
        r"\tau(t)=\frac{\det(\mathbf r'(t),\mathbf r''(t),\mathbf r'''(t))}{\|\mathbf r'(t)\times\mathbf r''(t)\|^2}",
        "tau: function 1; r: function 3",
        "tau(t) == det([r'(t), r''(t), r'''(t)])/norm(cross(r'(t), r''(t)))^2",
    ),
    (
        r"\kappa=\frac{x'y''-x''y'}{(x'^2+y'^2)^{3/2}}",
        "x(t) := t^2; y(t) := t^3",
        "kappa == (x'(t)*y''(t) - x''(t)*y'(t))/sqrt(x'(t)^2 + y'(t)^2)^3",
    ),
    (
        r"\kappa = \frac{|f''(x)|}{\left(1+f'(x)^2\right)^{3/2}}",
        "f: function 1",
        "kappa == abs(f''(x))/sqrt(1 + f'(x)^2)^3",
    ),
    (
        r"\mathbf{t}\cdot\mathbf{n}=0",
        "t: vector 3; n: vector 3",
        "dot(t, n) == 0",
    ),
    (
        r"\mathbf{b}=\mathbf{t}\times\mathbf{n}",
        "t: vector 3; n: vector 3; b: vector 3",
        "b == cross(t, n)",
    ),
    (
        r"\mathbf t'(s) = \kappa(s)\,\mathbf n(s)",
        "t: function 3; n: function 3; kappa: function 1",
        "t'(s) == kappa(s)*n(s)",
    ),
    (
        r"\frac{d\mathbf n}{ds}=-\kappa\mathbf t+\tau\mathbf b",
        "n(s) := [s, s, s]; t: vector 3; b: vector 3",
        "D(n(s), s) == -(kappa*t) + tau*b",
    ),
    (
        r"\|\mathbf{a}\times\mathbf{b}\|^2=\|\mathbf{a}\|^2\|\mathbf{b}\|^2-(\mathbf{a}\cdot\mathbf{b})^2",
        "a: vector 3; b: vector 3",
        "norm(cross(a, b))^2 == norm(a)^2*norm(b)^2 - dot(a, b)^2",
    ),
    (
        r"\mathbf a\times(\mathbf b\times\mathbf c)=\mathbf b(\mathbf a\cdot\mathbf c)-\mathbf c(\mathbf a\cdot\mathbf b)",
        "a: vector 3; b: vector 3; c: vector 3",
        "cross(a, cross(b, c)) == b*dot(a, c) - c*dot(a, b)",
    ),
    // surfaces
    (
        r"E=\mathbf X_u\cdot\mathbf X_u,\quad F=\mathbf X_u\cdot\mathbf X_v,\quad G=\mathbf X_v\cdot\mathbf X_v",
        "X(u, v) := [u, v, u*v]; u, v in [0, 1]",
        "E == dot(D(X, u)(u, v), D(X, u)(u, v)) and F == dot(D(X, u)(u, v), D(X, v)(u, v)) and G == dot(D(X, v)(u, v), D(X, v)(u, v))",
    ),
    (
        r"K=\frac{LN-M^2}{EG-F^2}",
        "",
        "K == (L*N - M^2)/(E*G - F^2)",
    ),
    (
        r"H=\frac{EN-2FM+GL}{2(EG-F^2)}",
        "G in (0, inf)",
        "H == (E*N - 2*F*M + G*L)/(2*(E*G - F^2))",
    ),
    (
        r"\mathbf{n}=\frac{\mathbf{X}_u\times\mathbf{X}_v}{\|\mathbf{X}_u\times\mathbf{X}_v\|}",
        "X(u, v) := [u, v, u*v]; u, v in [0, 1]; n: vector 3",
        "n == cross(D(X, u)(u, v), D(X, v)(u, v))/norm(cross(D(X, u)(u, v), D(X, v)(u, v)))",
    ),
    (
        r"L=\mathbf{X}_{uu}\cdot\mathbf{n},\ M=\mathbf{X}_{uv}\cdot\mathbf{n}",
        "X(u, v) := [u, v, u*v]; u, v in [0, 1]; n: vector 3",
        "L == dot(D(X, u, 2)(u, v), n) and M == dot(D(D(X, u), v)(u, v), n)",
    ),
    (
        r"\kappa_1\kappa_2=K",
        "kappa1, kappa2 in (-inf, inf)",
        "kappa1*kappa2 == K",
    ),
    (r"\kappa_{1,2}=H\pm\sqrt{H^2-K}", "kappa_1: function 1", "-"),
    (
        r"\kappa_1=H+\sqrt{H^2-K}",
        "kappa_1 in (-inf, inf)",
        "kappa_1 == H + sqrt(H^2 - K)",
    ),
    (
        r"\det\left(\mathbf{c}'(u),\mathbf{r}(u),\mathbf{r}'(u)\right)=0",
        "c: function 3; r: function 3",
        "det([c'(u), r(u), r'(u)]) == 0",
    ),
    (
        r"(\mathbf c'\times\mathbf r)\cdot\mathbf r'=0",
        "c(u) := [u, u, u]; r(u) := [u, 1, u]",
        "dot(cross(c'(u), r(u)), r'(u)) == 0",
    ),
    (
        r"\mathbf X(u,v)=\mathbf c(u)+v\,\mathbf r(u)",
        "X(u, v) := [u, v, 1]; c: function 3; r: function 3",
        "X(u, v) == c(u) + v*r(u)",
    ),
    (
        r"\lambda=\frac{\det(\mathbf c'(u),\mathbf e(u),\mathbf e'(u))}{\mathbf e'(u)\cdot\mathbf e'(u)}",
        "c: function 3; e: function 3",
        "lambda == det([c'(u), e(u), e'(u)])/dot(e'(u), e'(u))",
    ),
    (
        r"\mathbf S(u,v)=\sum_{i=0}^m\sum_{j=0}^n B_i^m(u)B_j^n(v)\,\mathbf P_{ij}",
        "S(u, v) := [u, v, 1]; m, n in 0..; B(i, n, t) := t; P[i, j] := [i, j, 1]",
        "S(u, v) == sum(i, 0, m, sum(j, 0, n, B(i, m, u)*B(j, n, v)*P[i, j]))",
    ),
    (
        r"\frac{\partial \mathbf{S}}{\partial u}(u,v)",
        "S(u, v) := [u, v, 1]",
        "-",
    ),
    (
        r"\frac{\partial^2 f}{\partial u\,\partial v}=\frac{\partial^2 f}{\partial v\,\partial u}",
        "f(u, v) := u*v; u, v in [0, 1]",
        "D(D(f(u, v), v), u) == D(D(f(u, v), u), v)",
    ),
    (
        r"C(u,v) = (1-v)c_0(u)+v c_1(u)",
        "C(u, v) := u*v; c_0: function 1; c_1: function 1",
        "C(u, v) == (1 - v)*c_0(u) + v*c_1(u)",
    ),
    (
        r"S(u,v)=(1-u)(1-v)P_{00}+u(1-v)P_{10}+(1-u)vP_{01}+uvP_{11}",
        "S(u, v) := u*v; P[i, j] := i + j",
        "S(u, v) == (1 - u)*(1 - v)*P[0, 0] + u*(1 - v)*P[1, 0] + (1 - u)*v*P[0, 1] + u*v*P[1, 1]",
    ),
    (
        r"\begin{vmatrix} E & F \\ F & G \end{vmatrix} > 0",
        "",
        "det([[E, F], [F, G]]) > 0",
    ),
    (
        r"\left(\begin{array}{cc} a & b \\ c & d \end{array}\right)\begin{pmatrix} x \\ y \end{pmatrix} = \begin{pmatrix} p \\ q \end{pmatrix}",
        "",
        "[[a, b], [c, d]]*[x, y] == [p, q]",
    ),
    (
        r"\mathbf N\cdot\mathbf X = d",
        "N: vector 3; X: vector 3",
        "dot(N, X) == d",
    ),
    // Hermite
    (
        r"H_0(t)=2t^3-3t^2+1",
        "H_0: function 1",
        "H_0(t) == 2*t^3 - 3*t^2 + 1",
    ),
    (
        r"H_1(t)=t(1-t)^2",
        "H_1: function 1; t in [0, 1]",
        "H_1(t) == t*(1 - t)^2",
    ),
    (
        r"\mathbf{p}(t)=\mathbf{p}_0H_0(t)+\mathbf{m}_0H_1(t)",
        "p: function 3; p_0: vector 3; m_0: vector 3; H_0: function 1; H_1: function 1",
        "p(t) == p_0*H_0(t) + m_0*H_1(t)",
    ),
    (
        r"\left.\frac{d}{dt}H(t)\right|_{t=0}=1",
        "H(t) := t",
        "at(D(H(t), t), t, 0) == 1",
    ),
    (
        r"f'(1)=\frac{3}{2}\bigl(f(1)-f(0)\bigr)-\frac12 f'(0)",
        "f: function 1",
        "f'(1) == 3/2*(f(1) - f(0)) - 1/2*f'(0)",
    ),
    // trigonometric bases
    (
        r"f_0(t)=(1-\sin t)(1-\lambda\sin t),\quad t\in[0,\tfrac{\pi}{2}]",
        "f_0: function 1",
        "f_0(t) == (1 - sin(t))*(1 - lambda*sin(t))",
    ),
    (
        r"\left(1-\sin\frac{\pi t}{2}\right)\left(1-\lambda\sin\frac{\pi t}{2}\right)\ge 0",
        "",
        "(1 - sin(pi*t/2))*(1 - lambda*sin(pi*t/2)) >= 0",
    ),
    (
        r"\sin^2\theta+\cos^2\theta=1",
        "",
        "sin(theta)^2 + cos(theta)^2 == 1",
    ),
    (
        r"\sin 2\theta = 2\sin\theta\cos\theta",
        "",
        "sin(2*theta) == 2*sin(theta)*cos(theta)",
    ),
    (
        r"\cos2\alpha=1-2\sin^{2}\alpha",
        "",
        "cos(2*alpha) == 1 - 2*sin(alpha)^2",
    ),
    (
        r"\sin(\alpha+\beta)=\sin\alpha\cos\beta+\cos\alpha\sin\beta",
        "",
        "sin(alpha + beta) == sin(alpha)*cos(beta) + cos(alpha)*sin(beta)",
    ),
    (
        r"1+\tan^2\varphi=\frac{1}{\cos^2\varphi}",
        "",
        "1 + tan(phi)^2 == 1/cos(phi)^2",
    ),
    (
        r"\cot\psi=\frac{\cos\psi}{\sin\psi}",
        "",
        "cos(psi)/sin(psi) == cos(psi)/sin(psi)",
    ),
    (
        r"b_0(t)=\frac{\sin^2\left(\frac{\alpha-t}{2}\right)}{\sin^2\frac{\alpha}{2}}",
        "b_0: function 1",
        "b_0(t) == sin((alpha - t)/2)^2/sin(alpha/2)^2",
    ),
    (r"\cosh^2 x-\sinh^2 x=1", "", "cosh(x)^2 - sinh(x)^2 == 1"),
    (
        r"\mathrm{e}^{x+y}=\mathrm{e}^{x}\mathrm{e}^{y}",
        "",
        "exp(x + y) == exp(x)*exp(y)",
    ),
    (r"\sin\pi t\le 1", "", "sin(pi*t) <= 1"),
    (
        r"\int_{0}^{\pi/2}\cos t\,\mathrm{d}t=1",
        "",
        "integral(cos(t), t, 0, pi/2) == 1",
    ),
    (
        r"\mathbf{r}(\theta)=(a\cos\theta,a\sin\theta,b\theta)",
        "r: function 3; a, b in (0, inf)",
        "r(theta) == [a*cos(theta), a*sin(theta), b*theta]",
    ),
    (
        r"a_{12}=\frac{\pi^{2}(1-\mu)}{4m}",
        "a_12 in (-inf, inf)",
        "a_12 == pi^2*(1 - mu)/(4*m)",
    ),
    // rational and other
    (
        r"R_i(t)=\frac{w_i B_i^n(t)}{\sum_{j=0}^n w_j B_j^n(t)}",
        "R(i, t) := t; w[i] := 1; B(i, n, t) := t; n in 0..; i in 0..n",
        "R(i, t) == w[i]*B(i, n, t)/sum(j, 0, n, w[j]*B(j, n, t))",
    ),
    (r"x^2+y^2=1", "", "x^2 + y^2 == 1"),
    (
        r"x=\frac{1-t^2}{1+t^2},\qquad y=\frac{2t}{1+t^2}",
        "",
        "x == (1 - t^2)/(1 + t^2) and y == 2*t/(1 + t^2)",
    ),
    (
        r"(a+b)^3=a^3+3a^2b+3ab^2+b^3",
        "",
        "(a + b)^3 == a^3 + 3*a^2*b + 3*a*b^2 + b^3",
    ),
    (
        r"\prod_{k=1}^n \frac{k+1}{k}=n+1",
        "n in 1..",
        "product(k, 1, n, (k + 1)/k) == n + 1",
    ),
    (
        r"\sum_{k=1}^{n}k=\frac{n(n+1)}{2}",
        "n in 1..",
        "sum(k, 1, n, k) == n*(n + 1)/2",
    ),
    (
        r"\sum_{k=0}^{n}(-1)^k\binom{n}{k}=0",
        "n in 1..",
        "sum(k, 0, n, (-1)^k*binom(n, k)) == 0",
    ),
    (r"1+2+\cdots+n=\frac{n(n+1)}{2}", "n in 1..", "-"),
    (
        r"\sqrt{a^2+b^2}\le|a|+|b|",
        "",
        "sqrt(a^2 + b^2) <= abs(a) + abs(b)",
    ),
    (
        r"\lvert\langle\mathbf a,\mathbf b\rangle\rvert\le\lVert\mathbf a\rVert\,\lVert\mathbf b\rVert",
        "a: vector 3; b: vector 3",
        "abs(dot(a, b)) <= norm(a)*norm(b)",
    ),
    (
        r"x(t)=(1-t)x_0+t x_1",
        "x: function 1; x_0, x_1 in [0, 1]",
        "x(t) == (1 - t)*x_0 + t*x_1",
    ),
    (
        r"\sigma'(t)^2=x'(t)^2+y'(t)^2",
        "sigma: function 1; x: function 1; y: function 1",
        "sigma'(t)^2 == x'(t)^2 + y'(t)^2",
    ),
    (
        r"x'(t)=u(t)^2-v(t)^2,\quad y'(t)=2u(t)v(t)",
        "x: function 1; y: function 1; u: function 1; v: function 1",
        "x'(t) == u(t)^2 - v(t)^2 and y'(t) == 2*u(t)*v(t)",
    ),
    (
        r"s=\int_0^t\|\mathbf{r}'(\tau)\|\,d\tau",
        "r: function 3",
        "s == integral(norm(r'(tau)), tau, 0, t)",
    ),
    (r"\text{if }x>0", "", "x > 0"),
    (
        r"\lambda\ne 0\implies \lambda^2>0",
        "",
        "lambda != 0 implies lambda^2 > 0",
    ),
    (
        r"x=0\iff x^2=0",
        "",
        "(x == 0 implies x^2 == 0) and (x^2 == 0 implies x == 0)",
    ),
    (r"0<t<1", "", "0 < t < 1"),
    (r"x\in[0,1]", "", "0 <= x <= 1"),
    (
        r"f(x)=\begin{cases}x,&x\ge0\\-x,&x<0\end{cases}",
        "f: function 1",
        "-",
    ),
    (r"\lim_{t\to0}\frac{\sin t}{t}=1", "", "-"),
    (r"\arctan 1=\frac{\pi}{4}", "", "atan(1) == pi/4"),
    (
        r"\mathbf{F}(\underbrace{t,\ldots,t}_{n})=\mathbf{c}(t)",
        "c: function 3",
        "-",
    ),
    (
        r"b(t_1,t_2)=(1-t_1)(1-t_2)b_0+(t_1+t_2-2t_1t_2)b_1+t_1t_2b_2",
        "b(x, y) := x*y; b_0, b_1, b_2, t_1, t_2 in (-inf, inf)",
        "b(t_1, t_2) == (1 - t_1)*(1 - t_2)*b_0 + (t_1 + t_2 - 2*t_1*t_2)*b_1 + t_1*t_2*b_2",
    ),
    (
        r"\beta_1 = \frac{\|\mathbf{q}'(0)\|}{\|\mathbf{p}'(1)\|}",
        "p: function 3; q: function 3; beta_1 in (0, inf)",
        "beta_1 == norm(q'(0))/norm(p'(1))",
    ),
    (
        r"\mathbf q''(0)=\beta_1^2\,\mathbf p''(1)+\beta_2\,\mathbf p'(1)",
        "p: function 3; q: function 3; beta1, beta2 in (0, inf)",
        "q''(0) == beta1^2*p''(1) + beta2*p'(1)",
    ),
    (
        r"A^{-1}A = A A^{-1}",
        "A := [[1, 2], [3, 4]]",
        "inverse(A)*A == A*inverse(A)",
    ),
    (
        r"\mathbf x^{T}A\mathbf x\ge 0",
        "A := [[1, 2], [3, 4]]; x: vector 2",
        "-",
    ),
    (
        r"(AB)^{\top}=B^{\top}A^{\top}",
        "A := [[1, 2], [3, 4]]; B := [[1, 2], [3, 4]]",
        "transpose(A*B) == transpose(B)*transpose(A)",
    ),
    (
        r"\hat{x}=\frac{x-a}{b-a}",
        "x_hat in [0, 1]",
        "x_hat == (x - a)/(b - a)",
    ),
];

#[test]
fn a_hundred_formulas_of_the_field_are_read_as_they_are_meant_or_refused() {
    let (mut understood, mut wrong) = (0, vec![]);
    for (print, setting, meant) in FORMULAS {
        // The setting declares; a statement with every meant name makes undeclared ones numbers.
        let states = if *meant == "-" { "1 == 1" } else { meant };
        let paper =
            question(states, setting).unwrap_or_else(|error| unreachable!("{print}: {error}"));
        let claim = paper.claims.first().unwrap();
        let names = latex_names(&claim.declarations);
        match (read_latex(print, &names), *meant) {
            (Err(_), "-") => {}
            (Ok(read), "-") => wrong.push(format!(
                "{print}\n  is read, {:?}",
                torse_syntax::notation::text(&read.statement.formula)
            )),
            (Err(error), _) => wrong.push(format!(
                "{print}\n  {error} at {:?}",
                print.get(error.place.start..error.place.end)
            )),
            (Ok(read), meant) => {
                understood += 1;
                if normal(&read.statement.formula) != normal_text(meant) {
                    wrong.push(format!(
                        "{print}\n  is {}\n  not {meant}",
                        torse_syntax::notation::text(&read.statement.formula)
                    ));
                }
                let others = read.others.iter().map(|(doubt, _)| doubt.says.join(" or "));
                let others: Vec<String> = others.collect();
                if !others.is_empty() {
                    wrong.push(format!("{print}\n  has other readings: {others:?}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(FORMULAS.len() >= 100, "{}", FORMULAS.len());
    assert!(understood >= 80, "{understood} of {}", FORMULAS.len());
}
